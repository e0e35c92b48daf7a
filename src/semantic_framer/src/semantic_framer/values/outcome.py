"""The outcome of an utterance (understood, refused or asked about), and the policy that decides how careful to be."""

from dataclasses import dataclass
from enum import Enum
from typing import Iterable, Optional, Sequence, Tuple, Union

from roboframenet_ros.spoken_text import join_with_and
from semantic_framer.values.clause_plan import PlanPart
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from typed_arguments import TypedArgument
from utterance_passes.phrases.clauses import Clause, excluded_phrase

#: Codes of refusals of objections to something that runs.
PROHIBITION = "NEGATED"
CORRECTION = "CORRECTION"
#: Codes of refusals of utterances that ask for nothing.
QUESTION = "QUESTION"
REPORT = "REPORT"
WISH = "WISH"
TALK = "TALK"
#: The person answers no or takes the sentence back; this does not concern anything that runs.
DECLINED = "DECLINED"
_REPLIES = {
    QUESTION: 'I do not know how to answer "{said}".',
    REPORT: '"{said}" does not ask me to do anything.',
    WISH: '"{said}" is something that you want to do. Tell me what I should do.',
    TALK: "I hear you. There is nothing for me to do.",
}
#: Replies to talk, by the name of the rule that classified it as talk.
_REPLIES_TO_TALK = {"thanks": "You are welcome.", "greeting": "Hello."}


class LeftOverWords(Enum):
    """What to do if a reading does not account for every content word."""

    ASK = "ask"  # ask whether to go on without extra-thematic phrases ("quickly"); refuse other words
    STRICT = "strict"  # refuse, and say which words
    WARN = "warn"  # act, and say which words
    IGNORE = "ignore"  # act, as in 2012


#: The policies that never act on a reading with words left over.
CAREFUL = frozenset([LeftOverWords.ASK, LeftOverWords.STRICT])


class Alternatives(Enum):
    """What to do with "the mug or the plate"."""

    ASK = "ask"
    EITHER = "either"


@dataclass(frozen=True)
class Policy:
    """How careful the framer is.

    Attributes:
        left_over_words: what to do with words that a reading does not account for
        alternatives: what to do with "or"
        question_timeout_s: how long a question may be answered
        fragment_timeout_s: how long a fragment ("again") may change or repeat the last command; 0 for never
        confirms: whether frames with the key ``confirm`` want a yes first
    """

    left_over_words: LeftOverWords = LeftOverWords.ASK
    alternatives: Alternatives = Alternatives.EITHER
    question_timeout_s: float = 30.0
    fragment_timeout_s: float = 60.0
    confirms: bool = True


#: For programs that want to know what a sentence means: nothing acts, so nobody is asked for a yes.
MEANING_ONLY = Policy(confirms=False)


@dataclass(frozen=True)
class Understood:
    """What to carry out.

    Attributes:
        clauses: each with its readings, best first, in the order of the plan
        warning: names the ignored words
        plan: how deeds and conditions are joined; None if the clauses are done one after the other
        beginning: what happens to the command that runs: REPLACE, FOLLOW or BESIDE
    """

    clauses: Tuple[Tuple[Reading, ...], ...]
    warning: str = ""
    plan: Optional[PlanPart] = None
    beginning: str = "REPLACE"


@dataclass(frozen=True)
class Refusal:
    """Nothing is done; ``code`` as in ``Reply.code``."""

    code: str
    sentence: str
    left_over: Tuple[str, ...] = ()


@dataclass(frozen=True)
class Question:
    """The framer must ask something first; ``code`` as in ``Reply.code``."""

    code: str
    sentence: str


@dataclass(frozen=True)
class Noted:
    """What was said is kept, and nothing else is done; ``code`` as in ``Reply.code``."""

    code: str
    sentence: str


Outcome = Union[Understood, Refusal, Question, Noted]


def reply_outcome(of: Union[Refusal, Question, Noted]) -> str:
    """Return the name of the constant of ``Reply`` for a command that ends in the framer."""
    if isinstance(of, Noted):
        return "DONE"
    return "REFUSED" if isinstance(of, Refusal) else "NEEDS_INFORMATION"


def left_over_refusal(sentence: Sentence, positions: Sequence[int], unheeded: Sequence[TypedArgument] = ()) -> Refusal:
    """Return the refusal of a sentence with left-over words.

    Args:
        sentence: the sentence
        positions: of the words
        unheeded: what was understood, but reaches no server
    """
    left = (sentence.word(index) for index in positions)
    words = tuple(word.form for word in left if word.upos != "PUNCT")
    if unheeded and set(positions) <= {index for argument in unheeded for index in argument.positions}:
        said = join_with_and([f'"{argument.words or argument.text}"' for argument in unheeded])
        part = "part" if len(unheeded) == 1 else "parts"
        return Refusal("LEFT_OVER_WORDS", f"I cannot do the {said} {part}, so I do nothing.", left_over=words)
    return Refusal(
        "LEFT_OVER_WORDS",
        f'I do not understand "{" ".join(words)}" in "{sentence.tree.text.strip()}", so I do nothing.',
        left_over=words,
    )


def lost_words_refusal(sentence: Sentence, words: Sequence[str]) -> Refusal:
    """Return the refusal of a sentence of which words are lost, by the words as they were said."""
    said = join_with_and([f'"{word}"' for word in words])
    return Refusal(
        "LEFT_OVER_WORDS",
        f'I do not understand {said} in "{sentence.tree.text.strip()}", so I do nothing.',
        left_over=tuple(words),
    )


def not_to_be_done(sentence: Sentence, clause: Clause, said: str) -> Refusal:
    """Return the refusal of a clause that is negated, or excludes something: "go there, but *not through the hall*"."""
    left_out = sorted(excluded_phrase(sentence.tree, clause))
    if left_out:
        return Refusal(PROHIBITION, f'I am not doing that. You said: "{sentence.text(left_out)}".')
    return Refusal(PROHIBITION, f'I am not doing that. You said not to: "{said}".')


def not_then(sentence: Sentence, positions: Iterable[int]) -> Refusal:
    """Return the refusal of a command for another time or under a condition."""
    said = sentence.text(sorted(positions)).strip(" ,")
    return Refusal("CONDITION", f'I do not understand "{said}" as a time or a condition, so I do nothing.')


def asks_for_nothing(code: str, rule: str, said: str) -> Refusal:
    """Return the refusal of an utterance that only asks or tells something.

    Args:
        code: its kind, a code of refusals
        rule: the name of the rule that decided its kind
        said: its words
    """
    reply = _REPLIES_TO_TALK.get(rule, _REPLIES[code])
    return Refusal(code, reply.format(said=said))
