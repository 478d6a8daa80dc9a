"""A slice of the study of mutations, and the state of its list."""

from tests.studies.mutations import MUTATIONS, ROOT, chosen, judged


def test_every_mutation_has_its_line_and_its_test():
    assert len(set(MUTATIONS)) == len(MUTATIONS) >= 30
    for each in MUTATIONS:
        assert (ROOT / each.file).read_text(encoding="utf-8").count(each.old) == 1, each
        assert each.old != each.new
        file, _, name = each.test.partition("::")
        assert f"def {name}" in (ROOT / file).read_text(encoding="utf-8"), each


def test_some_mutations_are_killed():
    assert [each.said for each in judged(chosen(2, 3))] == ["killed", "killed"]
