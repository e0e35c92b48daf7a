"""From the sentence of a question to answers that can be chosen: buttons of a page, phrases for a voice."""

import re
from typing import List, Mapping, Tuple

#: Answers to a question that is answered by yes or no.
YES_NO = ("Yes", "No")
_YES_NO_CODES = frozenset({"CONFIRM", "LEFT_OVER_WORDS"})
_QUOTED = re.compile(r'"([^"]{1,200})"')
_WHICH = re.compile(r"^Which[^:?]*: (?P<choices>.*)\?$")
#: Things of the world that a question names: others may be meant, so that the answer is open.
_NAMED = re.compile(r"^Which[^:,?]*, (?P<choices>[^?]*)\?")
_ANOTHER = "another one"
_LAST_OR = re.compile(r",? or ")
_EXAMPLE = re.compile(r'For instance: "([^"]{1,200})"')
_MOST_ANSWERS = 8


def closed_answers(code: str, sentence: str) -> Tuple[str, ...]:
    """Return the answers that a question allows: yes and no, or the choices that it names; none for an open question.

    Args:
        code: of the reply
        sentence: of the reply
    """
    if code in _YES_NO_CODES or sentence.startswith("Do you mean "):
        return YES_NO
    which = _WHICH.match(sentence)
    if which is None:
        return ()
    choices = _QUOTED.findall(which.group("choices"))
    if not choices:
        choices = _listed(which.group("choices"))
    return tuple(dict.fromkeys(choices))[:_MOST_ANSWERS]


def _listed(words: str) -> List[str]:
    before, *last = _LAST_OR.split(words)
    return [part.strip() for part in [*before.split(","), *last] if part.strip()]


def answers_to(code: str, sentence: str, names: Mapping[str, Tuple[str, ...]]) -> Tuple[str, ...]:
    """Return answers to the question of a reply that needs information: those that it allows, names or examples.

    Args:
        code: of the reply
        sentence: of the reply
        names: for the first word of a question in lower case ("where"), names that may answer it
    """
    closed = closed_answers(code, sentence)
    if closed:
        return closed
    examples = _EXAMPLE.findall(sentence)
    named = _NAMED.match(sentence)
    if named is not None:
        examples += [one for one in _listed(named.group("choices")) if one != _ANOTHER]
    first = sentence.partition(" ")[0].lower().strip("?,")
    answers = dict.fromkeys([*examples, *names.get(first, ())])
    return tuple(answers)[:_MOST_ANSWERS]
