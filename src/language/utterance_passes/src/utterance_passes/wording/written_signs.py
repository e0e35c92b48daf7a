"""Rewrites spellings that a tokenizer trained on text does not split: "90°", "3ft", "-3", "2½", "gonna"."""

import re
import unicodedata
from dataclasses import replace
from functools import partial

from spoken_quantities import DEGREE_SIGNS, number_words, plain_digits, unit_words
from utterance_passes.engine.utterance_pass import Example, Kind, text_pass
from utterance_passes.trees.formula_file import WRITTEN_OUT, shipped_formulas
from utterance_passes.trees.spelling import Spelling, replaced, stripped
from word_classes import word_list

#: Words that can begin a number.
_NUMBER = f"(?:{'|'.join(number_words())})"

_TRANSCRIBERS_MARK = re.compile(r"<[a-zA-Z _-]{1,30}>")
_APOSTROPHE = re.compile(r"[‘’ʼ`]")
_QUOTATION_MARK = re.compile(r"[“”«»]")
#: Words between single marks: 'I'm here'. An apostrophe inside a word, or at the end of "dogs'", is no mark; nor is
#: that of "pick 'em up".
_SINGLE_MARKED = re.compile(
    rf"(?<![\w'])'(?!(?:{'|'.join(word_list('elided_words'))})\b)"
    r"(?=[^\W\d])((?:[^'\"]|(?<=\w)'(?=\w))*[^\s'\"])'(?!\w)",
    re.IGNORECASE,
)
_DASH = re.compile(r"[‐‑–—\u2212]")
#: A sign for a fraction, or a digit, a letter or a mark of another width: "½", "\uff13".
_NUMBER_SIGN = re.compile(r"[¼½¾⅐-⅞]|[\uff01-\uff5e]|(?![0-9])\d")
_FRACTION_SLASH = re.compile(r"(?<=\d)\u2044(?=\d)")
_DEGREE_SIGN = re.compile(rf"(?<=\w)\s*[{DEGREE_SIGNS}]")
#: The place between a number and the unit that touches it.
_UNIT_AT_NUMBER = re.compile(
    rf"(?<=\d)(?=(?:{'|'.join(sorted(filter(str.isalpha, unit_words()), key=len, reverse=True))})\b)", re.IGNORECASE
)
_MINUS_SIGN = re.compile(rf"(?<!\S)-(?=\.?\d|{_NUMBER}\b)", re.IGNORECASE)
_NEGATIVE_SIGN = re.compile(rf"\bnegative\s+(?=\.?\d|{_NUMBER}\b)", re.IGNORECASE)
_RATIO = re.compile(r"(?<=\d)/(?=\d)")
_BLANKS = re.compile(r"\s+")
_CONTRACTIONS = tuple(
    (re.compile(rf"(?<![\w'-])(?:{formula.pattern.pattern})(?![\w'-])", re.IGNORECASE), formula.written)
    for formula in shipped_formulas()[WRITTEN_OUT]
)


@text_pass(Kind.SPELLING, Example("go <pause> on", ("go   on",)))
def transcribers_marks(spelling: Spelling) -> Spelling:
    """Remove the marks of transcribers and speech recognisers: "<pause>", "<no speech>"."""
    return replaced(spelling, _TRANSCRIBERS_MARK, " ")


@text_pass(Kind.SPELLING, Example("Bob’s", ("Bob's",)))
def apostrophes(spelling: Spelling) -> Spelling:
    """Write all apostrophes alike."""
    return replaced(spelling, _APOSTROPHE, "'")


@text_pass(Kind.SPELLING, Example("say “hi” and 'I'm here'", ('say "hi" and "I\'m here"',)))
def quotation_marks(spelling: Spelling) -> Spelling:
    """Write all quotation marks alike, single ones too."""
    text = _SINGLE_MARKED.sub(r'"\1"', _QUOTATION_MARK.sub('"', spelling.text))
    return replace(spelling, text=text)


@text_pass(Kind.SPELLING, Example("pick–up", ("pick-up",)))
def dashes(spelling: Spelling) -> Spelling:
    """Write all dashes alike."""
    return replaced(spelling, _DASH, "-")


@text_pass(Kind.SPELLING, Example("２½", ("2 1/2",)))
def fraction_signs(spelling: Spelling) -> Spelling:
    """Write the sign for a fraction, and digits of another width, in plain digits."""
    return replaced(spelling, _NUMBER_SIGN, _plain_sign)


def _plain_sign(sign: "re.Match[str]") -> str:
    """Return "½" as "1/2", with a blank between it and digits before it, and another sign as a plain one."""
    plain = plain_digits(sign.group(0))
    if plain != sign.group(0):
        return plain
    digits = unicodedata.normalize("NFKC", sign.group(0)).replace("\u2044", "/")
    return (" " if sign.string[: sign.start()][-1:].isalnum() else "") + digits


@text_pass(Kind.SPELLING, Example("1⁄2", ("1/2",)))
def fraction_slash(spelling: Spelling) -> Spelling:
    """Write the slash in a fraction as a plain one."""
    return replaced(spelling, _FRACTION_SLASH, "/")


@text_pass(Kind.SPELLING, Example("90°", ("90 degrees",)))
def degree_sign(spelling: Spelling) -> Spelling:
    """Write the sign for degrees as a word."""
    return replaced(spelling, _DEGREE_SIGN, " degrees")


@text_pass(Kind.SPELLING, Example("3ft", ("3 ft",)))
def units(spelling: Spelling) -> Spelling:
    """Separate a number from a unit that touches it."""
    return replaced(spelling, _UNIT_AT_NUMBER, " ")


@text_pass(Kind.SPELLING, Example("-3", ("minus 3",)))
def minus_sign(spelling: Spelling) -> Spelling:
    """Write the sign of a negative number as a word."""
    return replaced(spelling, _MINUS_SIGN, "minus ")


@text_pass(Kind.SPELLING, Example("negative two", ("minus two",)))
def negative_sign(spelling: Spelling) -> Spelling:
    """Write "negative" before a number as "minus"."""
    return replaced(spelling, _NEGATIVE_SIGN, "minus ")


@text_pass(Kind.SPELLING, Example("3/4", ("3 / 4",)))
def ratios(spelling: Spelling) -> Spelling:
    """Separate the two numbers of a ratio."""
    return replaced(spelling, _RATIO, " / ")


@text_pass(Kind.SPELLING, Example("didnt move, I'm gonna go", ("didn't move, I'm going to go",)))
def contractions(spelling: Spelling) -> Spelling:
    """Write contracted words in full: "gonna", "dont"."""
    for pattern, written in _CONTRACTIONS:
        spelling = replaced(spelling, pattern, partial(_in_full, written=written))
    return spelling


def _in_full(short: "re.Match[str]", written: str) -> str:
    full = short.expand(written)
    return full[:1].upper() + full[1:] if short.group()[:1].isupper() else full


@text_pass(Kind.SPELLING, Example("go \t on", ("go on",)))
def blanks(spelling: Spelling) -> Spelling:
    """Write one blank between words."""
    return replaced(spelling, _BLANKS, " ")


@text_pass(Kind.SPELLING, Example(" go ", ("go",)))
def ends(spelling: Spelling) -> Spelling:
    """Remove blanks at both ends."""
    return stripped(spelling)
