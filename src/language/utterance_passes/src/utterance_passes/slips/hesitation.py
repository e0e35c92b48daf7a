"""Removes what people say while they think, and what they break off: "go to the ki- to the, you know, kitchen"."""

import re
from typing import Optional, Tuple

from spoken_quantities import number_words
from utterance_passes.engine.utterance_pass import Example, Kind, text_pass
from utterance_passes.trees.formula_file import any_of, shipped_formulas
from utterance_passes.trees.spelling import Spelling, replaced
from word_classes import word_class

#: Words that can begin a number.
_NUMBER = f"(?:{'|'.join(number_words())})"
#: A word that was broken off: "the ki- ...", but not "two- or three-metre".
_BROKEN_OFF = re.compile(rf"(?<![\w-])(?!{_NUMBER}-)[^\W\d_]+-,?(?=\s+(?!(?:or|and|to)\b)\S)", re.IGNORECASE)
_SAID = re.compile(r"[\w']+")
_PHRASE = any_of(shipped_formulas()["phrases_of_hesitation"]).pattern
_SET_OFF = f"{_PHRASE}|{any_of(shipped_formulas()['fillers']).pattern}|like"
_NUMERAL = re.compile(rf"\d+|{_NUMBER}", re.IGNORECASE)
_BETWEEN_COMMAS = re.compile(rf",\s*(?:{_SET_OFF})\s*,", re.IGNORECASE)
_OF_CLAUSES = word_class("question_words") | word_class("relative_pronouns") | word_class("conditions")
#: "You know" is no hesitation before what is known, and behind what asks for it: "do *you know* where the mug is".
_OBJECT = "|".join(
    sorted(
        _OF_CLAUSES
        | word_class("whether_words")
        | word_class("pronouns_of_persons")
        | word_class("determiners_and_possessives")
        | word_class("things_asked")
        | word_class("object_pronouns")
        | {"about", "of"}
    )
)
_HESITATION = re.compile(rf"(?<![\w'-])(?:{_PHRASE})(?![\w'-])(?!\s*(?:{_OBJECT})\b)", re.IGNORECASE)
_BEFORE = _OF_CLAUSES | word_class("forms_of_do") | word_class("reason_conjunctions") | {"the", "than"}
_BEFORE_KNOWING = re.compile(rf"(?:{'|'.join(sorted(_BEFORE))})\s*$", re.IGNORECASE)
_SAYING = word_class("saying_verbs")
_UNFINISHED = word_class("only_before_nouns") | word_class("to_prepositions") | word_class("placing_prepositions")
#: A filler behind a word that another one must follow: "go to *uh* the kitchen". A parser takes it for a verb.
_INSIDE_PHRASE = re.compile(
    rf"(?<![\w'-])(?P<before>{'|'.join(sorted(_UNFINISHED))})\s*,?\s+(?:{any_of(shipped_formulas()['fillers']).pattern})"
    r"\s*,?(?=\s+\w)",
    re.IGNORECASE,
)


@text_pass(Kind.DISFLUENCY, Example("go to the ki- go to the kitchen", ("go to the kitchen",)))
def false_starts(spelling: Spelling) -> Spelling:
    """Remove words that the speaker broke off, and what they say again: "go to the ki- go to the kitchen"."""
    while True:
        match = _BROKEN_OFF.search(spelling.text)
        if match is None:
            return spelling
        before = list(_SAID.finditer(spelling.text, 0, match.start()))
        behind = _SAID.search(spelling.text, match.end())
        again = behind.group().lower() if behind else ""
        start = next((word.start() for word in reversed(before) if word.group().lower() == again), match.start())
        end = behind.start() if behind else match.end()
        spelling = spelling.without(start, end)


@text_pass(Kind.DISFLUENCY, Example("go to the go to the office", ("go to the office",)))
def repeated_starts(spelling: Spelling) -> Spelling:
    """Remove the beginning of a phrase that the speaker begins again: "go to the go to the office"."""
    start = _start_said_twice(spelling.text)
    while start is not None:
        spelling = spelling.without(*start)
        start = _start_said_twice(spelling.text)
    return spelling


def _start_said_twice(text: str) -> Optional[Tuple[int, int]]:
    """Return where the beginning of a phrase begins and where it begins again, the longest first; None if nowhere."""
    words = list(_SAID.finditer(text))
    forms = [word.group().lower() for word in words]
    for length in range(len(forms) // 2, 1, -1):
        for first in range(len(forms) - 2 * length):
            second = first + length
            if forms[first:second] == forms[second : second + length] and forms[second - 1] in _UNFINISHED:
                return words[first].start(), words[second].start()
    return None


@text_pass(Kind.DISFLUENCY, Example("go to the, you know, kitchen", ("go to the kitchen",)))
def hesitation(spelling: Spelling) -> Spelling:
    """Remove phrases that people say while they think, unless somebody is to say them: "the, you know, kitchen"."""
    # Behind a verb of saying, they may be part of the message.
    while not _SAYING & {word.group().lower() for word in _SAID.finditer(spelling.text)}:
        spelling = replaced(spelling, _BETWEEN_COMMAS, _without_filler)
        spelling = replaced(spelling, _INSIDE_PHRASE, lambda match: match["before"])
        found = _HESITATION.finditer(spelling.text)
        match = next((one for one in found if not _BEFORE_KNOWING.search(spelling.text[: one.start()])), None)
        if match is None or not spelling.text[match.end() :].strip(" .!?,"):
            break
        spelling = spelling.without(match.start(), match.end())
    return spelling


def _without_filler(found: "re.Match[str]") -> str:
    """Return nothing for a filler between commas; between two numbers it stays, because one may correct the other."""
    before = re.findall(r"[^\W_]+", found.string[: found.start()])[-1:]
    behind = re.findall(r"[^\W_]+", found.string[found.end() :])[:1]
    return found.group() if len([word for word in before + behind if _NUMERAL.fullmatch(word)]) == 2 else ""
