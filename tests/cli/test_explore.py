"""`cadgen explore` and `cadgen merge` as a user calls them."""

import json
import tomllib

import pytest

STUDY = """
name = "orders"
objectives = ["worst_end_mm", "disc_diameter_mm"]
record = ["return_error_deg"]

[plan]
kind = "full_factorial"

[[vary]]
key = "optimize.order"
values = ["as-given", "reordered"]

[[vary]]
key = "cam.base_radius_mm"
values = [35.0, 66.0]

[[limits]]
figure = "drift_mm"
most = 400
"""
MAIN = "from cadgen.cli import main; main()"


@pytest.fixture(scope="module")
def study(tmp_path_factory):
    folder = tmp_path_factory.mktemp("explore")
    (folder / "orders.toml").write_text(STUDY)
    return folder


def test_wrong_calls_are_one_sentence(study, forks):
    def said(*arguments: str) -> tuple[int, str]:
        done = forks.run(MAIN, *arguments, cwd=study)
        assert "\n" not in done.stderr.strip()
        return done.returncode, done.stderr

    assert said("explore", "none.toml", "--out", "x")[0] == 2
    code, words = said("explore", "orders.toml", "--out", "x", "--shard", "5/3")
    assert (code, "it must be k/n" in words) == (2, True)
    code, words = said("merge", ".", "--out", "x")
    assert (code, "there is no journal" in words) == (3, True)


@pytest.mark.slow
@pytest.mark.long
def test_a_study_by_shards_and_its_best_design(study, forks):
    """The best design's file gives the figures of its row, and a shard's journal those of the whole."""
    for shard in ("1/2", "2/2"):
        arguments = ("explore", "orders.toml", "--out", "out", "--processes", "1", "--shard", shard)
        assert forks.run(MAIN, *arguments, cwd=study).returncode == 0
    done = forks.run(MAIN, "merge", "out", "--out", "out", "--json", cwd=study)
    assert done.returncode == 0, done.stderr
    entry = json.loads(done.stdout)
    assert entry["designs"] == 4
    # A base radius of 35 mm is too small for the pressure angle; play is less with the reordered train.
    assert entry["states"] == {"kept": 2, "outside": 2}
    (best,) = entry["front"]
    assert (best["optimize.order"], best["cam.base_radius_mm"]) == ("reordered", 66.0)
    text = (study / "out" / "orders_best_1.toml").read_text()
    assert tomllib.loads(text)["optimize"]["order"] == "reordered"
    assert "# a, camshaft to fork axis" in text
    checked = forks.run(MAIN, "check", "out/orders_best_1.toml", "--json", cwd=study)
    after = json.loads(checked.stdout)["play"]["after"]
    assert after["worst_end_position_mm"] == pytest.approx(best["worst_end_mm"], abs=1e-9)
    assert forks.run(MAIN, "verify", "out", cwd=study).returncode == 0
