"""What ``rfn doctor`` finds."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Finding:
    """One thing that was looked at; ``advice`` is empty when it is well."""

    subject: str
    found: str
    advice: str = ""

    def __str__(self) -> str:
        text = f"{'problem' if self.advice else 'ok':<8} {self.subject:<14} {self.found}"
        return f"{text}\n{'':<24}-> {self.advice}" if self.advice else text
