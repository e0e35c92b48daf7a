"""A finding of ``rfn doctor``."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Finding:
    """The result of one check; ``advice`` is empty when there is no problem."""

    subject: str
    found: str
    advice: str = ""

    def __str__(self) -> str:
        text = f"{'problem' if self.advice else 'ok':<8} {self.subject:<14} {self.found}"
        return f"{text}\n{'':<24}-> {self.advice}" if self.advice else text
