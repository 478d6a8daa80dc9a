"""The version, in its one place: the package, its files and its build read it here."""

__version__ = "0.3.0"
