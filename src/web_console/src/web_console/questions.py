"""From the sentence of a reply to the answers that the page offers as buttons."""

import re
from typing import Mapping, Optional, Tuple

from web_console.views import QuestionView

_YES_NO = ("Yes", "No")
_YES_NO_CODES = frozenset({"CONFIRM", "LEFT_OVER_WORDS"})
_QUOTED = re.compile(r'"([^"]{1,200})"')
_WHICH = re.compile(r"^Which[^:?]*: (?P<choices>.*)\?$")
_LAST_OR = re.compile(r",? or ")
_EXAMPLE = re.compile(r'For instance: "([^"]{1,200})"')
_MOST_ANSWERS = 8


def question_of(code: str, sentence: str, names: Mapping[str, Tuple[str, ...]]) -> Optional[QuestionView]:
    """Return the question of a reply that needs information, with answers to choose from.

    Args:
        code: of the reply
        sentence: of the reply
        names: for the first word of a question in lower case ("where"), names that may answer it
    """
    if code in _YES_NO_CODES:
        return QuestionView(sentence, _YES_NO)
    which = _WHICH.match(sentence)
    if which is not None:
        choices = _QUOTED.findall(which.group("choices"))
        if not choices:
            before, *last = _LAST_OR.split(which.group("choices"))
            choices = [part.strip() for part in [*before.split(","), *last] if part.strip()]
        return QuestionView(sentence, tuple(dict.fromkeys(choices))[:_MOST_ANSWERS])
    if sentence.startswith("Do you mean "):
        return QuestionView(sentence, _YES_NO)
    examples = _EXAMPLE.findall(sentence)
    first = sentence.partition(" ")[0].lower().strip("?,")
    answers = dict.fromkeys([*examples, *names.get(first, ())])
    return QuestionView(sentence, tuple(answers)[:_MOST_ANSWERS])
