"""What the distribution says of itself where it depends on where the repository lies.

CADGEN_REPOSITORY, an address such as `https://example.org/cadgen`, is set where the distribution is built to be
published. Then the project has its addresses, and links and pictures of the README lead there. Without it the README of
the distribution has neither, for an index has no files beside it.
"""

import os
import re
from typing import Any

try:
    from hatchling.metadata.plugin.interface import MetadataHookInterface
except ModuleNotFoundError:  # for the tests, which have no use for a builder
    MetadataHookInterface = object

VARIABLE = "CADGEN_REPOSITORY"
_PICTURE = re.compile(r"!\[([^]]*)\]\(((?!https?:)[^)]+)\)")
_LINK = re.compile(r"(?<!!)\[([^]]*)\]\(((?!https?:|#)[^)]+)\)")


def readme_for(text: str, repository: str) -> str:
    """README as an index shows it.

    Args:
        text: README of the repository, in Markdown.
        repository: address of the repository; empty where it has none.
    """
    if repository:
        text = _PICTURE.sub(rf"![\1]({repository}/raw/main/\2)", text)
        return _LINK.sub(rf"[\1]({repository}/blob/main/\2)", text)
    text = re.sub(r"^(?:\| )?!\[[^]]*\]\([^)]*\)\n", "", text, flags=re.M)
    return _LINK.sub(r"\1", _PICTURE.sub("", text))


class Metadata(MetadataHookInterface):
    """Hook of the builder."""

    PLUGIN_NAME = "custom"

    def update(self, metadata: dict[str, Any]) -> None:
        """Put README and addresses into the metadata of the project."""
        repository = os.environ.get(VARIABLE, "").rstrip("/")
        with open(os.path.join(self.root, "README.md"), encoding="utf-8") as stream:
            metadata["readme"] = {"content-type": "text/markdown", "text": readme_for(stream.read(), repository)}
        if repository:
            metadata["urls"] = {
                "Repository": repository,
                "Documentation": f"{repository}/blob/main/docs/index.md",
                "Changelog": f"{repository}/blob/main/CHANGELOG.md",
            }
