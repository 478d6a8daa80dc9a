"""Texts for people: an English template with named arguments, which can be said in other languages.

A `Message` is the English text, and keeps its template and arguments. `translate` says it in another language by the
catalogues in `cadgen/locale/LANGUAGE/*.po`, whose keys are the English templates; a plug-in has its own in the same
folders of its package. What has no entry stays English. Only what shows texts to people translates: values, JSON and
manifests are English in every language.
"""

import logging
from collections.abc import Iterable, Mapping
from contextvars import ContextVar
from functools import cache, partial, reduce
from importlib.resources import files
from importlib.util import find_spec

_log = logging.getLogger(__name__)
ENGLISH, CHINESE = "en", "zh"
LANGUAGES = (ENGLISH, CHINESE)
# Environment variables by which a system states its user's language, in the order in which gettext asks them.
_VARIABLES = ("LANGUAGE", "LC_ALL", "LC_MESSAGES", "LANG")
_chosen: ContextVar[str] = ContextVar("language", default=ENGLISH)
_PACKAGES = ["cadgen"]  # that have catalogues, the first of which counts where several have a text


class Message(str):
    """English text for people that remembers its template and arguments.

    Args:
        template: text with fields such as `{angle:.2f}`; without arguments it is taken as it stands.
        arguments: values of the fields; a message among them is translated with the whole.

    Example:
        >>> Message("cam angle {angle:.2f}°", angle=12.3456)
        'cam angle 12.35°'
    """

    template: str
    arguments: Mapping[str, object]

    def __new__(cls, template: str, /, **arguments: object) -> "Message":
        """Format a template, and keep it with its arguments."""
        if isinstance(template, Message) and not arguments:
            return template
        made = super().__new__(cls, template.format(**arguments) if arguments else template)
        made.template, made.arguments = str(template), arguments
        return made

    def __reduce__(self) -> tuple[object, ...]:
        return partial(Message, self.template, **self.arguments), ()

    def translated(self, language: str) -> str:
        """Text in a language.

        Args:
            language: code of the language, such as `zh`.
        """
        template = _catalogue(language).get(self.template, self.template)
        if not self.arguments:
            return template
        return template.format(**{name: translate(value, language) for name, value in self.arguments.items()})


class _Joined(Message):
    """Messages in a row, each translated by itself."""

    parts: tuple[str, ...]
    separator: str

    def __reduce__(self) -> tuple[object, ...]:
        return joined, (self.parts, self.separator)

    def translated(self, language: str) -> str:
        """Texts in a language, with the separator of that language between them."""
        between = _catalogue(language).get(self.separator, self.separator)
        return between.join(str(translate(part, language)) for part in self.parts)


def joined(parts: Iterable[str], separator: str = ", ") -> Message:
    """Put messages and plain texts in a row, as in a list.

    Args:
        parts: texts; plain ones are names and numbers, the same in every language.
        separator: text between them, which has a translation, too.
    """
    kept = tuple(parts)
    made = str.__new__(_Joined, separator.join(kept))
    made.template, made.arguments, made.parts, made.separator = str(made), {}, kept, separator
    return made


class _Sentence(Message):
    """Clause with a large first letter and a full stop."""

    def __reduce__(self) -> tuple[object, ...]:
        return sentence, (self.arguments["clause"],)

    def translated(self, language: str) -> str:
        """Sentence in a language."""
        clause = str(translate(self.arguments["clause"], language))
        return f"{clause[:1].upper()}{clause[1:]}{shown('.', language)}"


def sentence(clause: str) -> Message:
    """Make a sentence of a clause.

    Args:
        clause: message that begins with a small letter and has no full stop.
    """
    made = str.__new__(_Sentence, f"{clause[:1].upper()}{clause[1:]}.")
    made.template, made.arguments = str(made), {"clause": Message(clause)}
    return made


def clauses(first: str, *others: str) -> Message:
    """Put clauses in a row, with a comma before each but the first: `stage 2, least`.

    Args:
        first, others: texts.
    """
    return reduce(lambda said, more: Message("{said}, {more}", said=said, more=more), others, Message(first))


def translate(value: object, language: str | None = None) -> object:
    """Say a message in a language; every other value is given back as it is.

    Args:
        value: message, or a value of another type, such as a name or a number.
        language: code of the language; the one chosen by `choose` if left out.
    """
    language = language or _chosen.get()
    return value.translated(language) if isinstance(value, Message) and language != ENGLISH else value


def shown(text: str, language: str | None = None) -> str:
    """Text for people in a language: a message translated, a plain label looked up in the catalogue.

    Args:
        text: message or label.
        language: code of the language; the one chosen by `choose` if left out.
    """
    language = language or _chosen.get()
    if language == ENGLISH:
        return text
    return text.translated(language) if isinstance(text, Message) else _catalogue(language).get(text, text)


def choose(language: str) -> None:
    """Show texts in a language from now on.

    Args:
        language: one of `LANGUAGES`.
    """
    _chosen.set(language)


def language() -> str:
    """Code of the language in which texts are shown."""
    return _chosen.get()


def language_of(environment: Mapping[str, str]) -> str:
    """Language that a system's environment states; English if it states none that there is.

    Args:
        environment: variables, such as `os.environ`.
    """
    stated = next((environment[name] for name in _VARIABLES if environment.get(name)), "")
    return next((code for code in LANGUAGES if stated.lower().startswith(code)), ENGLISH)


def speak_for(package: str) -> None:
    """Translate a package's texts, too, by the catalogues `locale/LANGUAGE/*.po` in its folder, if it has any.

    Args:
        package: name of the package of a plug-in; a module of one file has no folder.
    """
    spec = find_spec(package)
    if package not in _PACKAGES and spec is not None and spec.submodule_search_locations:
        _PACKAGES.append(package)
        _catalogue.cache_clear()


@cache
def _catalogue(language: str) -> Mapping[str, str]:
    """Translations by English template, from all catalogues of a language."""
    known: dict[str, str] = {}
    for package in reversed(_PACKAGES):
        folder = files(package).joinpath("locale", language)
        names = sorted(file.name for file in folder.iterdir()) if folder.is_dir() else []
        for name in names:
            if name.endswith(".po"):
                try:
                    known |= catalogue(language, name.removesuffix(".po"), package)
                except (OSError, ValueError) as error:
                    if package == _PACKAGES[0]:
                        raise
                    _log.warning("the catalogue %s of the plug-in %s cannot be read (%s)", name, package, error)
    return known


def catalogue(language: str, name: str, package: str = "cadgen") -> dict[str, str]:
    """Translations of one catalogue by English template.

    Args:
        language: code of the language, such as `zh`.
        name: name of the catalogue's file, without `.po`.
        package: package in whose folder it stands.

    Raises:
        OSError: the catalogue is none that can be read.
    """
    from polib import pofile  # loaded for another language alone

    text = files(package).joinpath("locale", language, f"{name}.po").read_text("utf-8")
    return {entry.msgid: entry.msgstr for entry in pofile(text) if entry.msgstr}
