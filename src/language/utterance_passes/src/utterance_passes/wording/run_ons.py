"""Finds commands in a row: "open the cupboard close the drawer", "I am back. Open the door".

Speech recognisers give no punctuation, and a parser trained on text does not take the second verb for a verb. So the
utterance is cut where a known verb with its own object follows a complete phrase, and each part is parsed alone.
"""

from typing import Sequence, Tuple

from semantic_types import shipped_types
from spoken_quantities import find_number
from utterance_passes.engine.utterance_pass import Example, Kind, cut_pass
from utterance_passes.trees.tree import QUOTATION_MARKS
from utterance_passes.trees.vocabulary import OBJECT_BEGINNINGS, Verbs, Vocabulary
from word_classes import word_class

#: Who turns around has turned: "turn around *head to the door*".
_AROUND = "around"
_FORMS_OF_BE = word_class("forms_of_be")
_LEADING_VERBS = word_class("leading_verbs")
_LEAD_IN = word_class("lead_in")
_MODALS = word_class("polite_modals") - {"may"}
_NEVER_LAST = word_class("padding") | word_class("negating_adverbs") | word_class("to_prepositions")
_OBJECT_PRONOUNS = word_class("object_pronouns")
_PARTICLES = word_class("verb_particles")
_SENTENCE_ENDS = frozenset([".", "!", "?"])
_SAYING = word_class("saying_verbs")
_SUBJECTS = word_class("subject_pronouns") - word_class("pronouns_of_things")
_TO = word_class("to_prepositions")
_WITH_A_VERB = word_class("verbs_with_verbs")
#: Names of times, and the words around them.
_TIMES = frozenset().union(
    *(word_class(name) for name in ("periods", "weekdays", "times_of_day", "clock_words", "time_adverbs"))
)
_OF_TIMES = frozenset().union(
    *(word_class(name) for name in ("time_prepositions", "time_determiners", "time_modifiers", "determiners_of_all"))
)
#: Words that join a command to the one before it; the parser handles them.
_JOINING = word_class("words_between_commands")
#: Parts of speech that can end a complete phrase.
_COMPLETE = frozenset(["NOUN", "PROPN", "PRON", "NUM", "ADV", "INTJ", "SYM"])


@cut_pass(
    Kind.REPAIR,
    Example("open|VERB the|DET box|NOUN close|ADP the|DET door|NOUN", ("4",), Verbs(frozenset(["open", "close"]))),
)
def run_ons(forms: Sequence[str], tags: Sequence[str], vocabulary: Vocabulary) -> Tuple[int, ...]:
    """Separate commands that have no mark between them.

    Args:
        forms: words of the utterance
        tags: their universal parts of speech
        vocabulary: known verbs
    Returns:
        positions of these words, from 1
    """
    said = [form.lower() for form in forms]
    if _SAYING & frozenset(said):
        return ()
    found = []
    for position in range(2, len(said) - 1):
        first = position
        while first > 1 and said[first - 1] in _LEAD_IN - _JOINING:
            first -= 1
        is_joined = said[first - 1] in _JOINING
        if (
            not is_joined
            and _begins_command(said, tags, position, vocabulary)
            and _is_complete(said[:first], tags[:first])
        ):
            found.append(first + 1)
    return tuple(found)


def sentences(forms: Sequence[str], tags: Sequence[str], vocabulary: Vocabulary) -> Tuple[int, ...]:
    """Find the first word of each further sentence that is a command: "I think I lost my keys. *Look* for them".

    The parser would attach some of them to a verb of the sentence before. What somebody is to be told may have several
    sentences.

    Args:
        forms: words of the utterance
        tags: their universal parts of speech
        vocabulary: known verbs
    Returns:
        positions of these words, from 1
    """
    said = [form.lower() for form in forms]
    if QUOTATION_MARKS & frozenset(forms):
        return ()
    found = []
    for position in range(2, len(said)):
        if _SAYING & frozenset(said[:position]):
            break
        if forms[position - 1] not in _SENTENCE_ENDS or tags[position - 1] != "PUNCT":
            continue
        first = next((place for place in range(position, len(said)) if said[place] not in _LEAD_IN), None)
        if first is None:
            continue
        is_asked = said[first] in _MODALS and said[first + 1 : first + 2] == ["you"]
        is_verb = tags[first] != "AUX" and bool(vocabulary.verbs_beginning_with(said[first]))
        if is_asked or is_verb:
            found.append(position + 1)
    return tuple(found)


def _begins_command(said: Sequence[str], tags: Sequence[str], position: int, vocabulary: Vocabulary) -> bool:
    following = said[position + 1]
    if (
        tags[position - 1] == "NOUN"
        and following not in OBJECT_BEGINNINGS
        and _is_two_word_noun(*said[position - 1 : position + 1])
    ):
        return False  # "To the night *stand* to the left".
    if said[position] in _MODALS:
        behind = position + 2 + (said[position + 2 : position + 3] == ["please"])
        return following == "you" and bool(vocabulary.verbs_beginning_with("".join(said[behind : behind + 1])))
    if not vocabulary.verbs_beginning_with(said[position]) or tags[position] == "AUX":
        return False
    # Behind a time, the parser takes the verb for a noun: "at eight turn on the light".
    is_phrasal = following in _PARTICLES and (tags[position] == "VERB" or _is_time(said[:position]))
    # "I am hungry *go to the kitchen*", "turn right *head to the door*".
    is_way = following in _TO and (
        tags[position] == "VERB"
        or (tags[position] == "NOUN" and (tags[position - 1] == "ADV" or said[position - 1] == _AROUND))
    )
    return following in OBJECT_BEGINNINGS or (
        (is_phrasal or is_way) and "".join(said[position + 2 : position + 3]) in OBJECT_BEGINNINGS
    )


def _is_complete(said: Sequence[str], tags: Sequence[str]) -> bool:
    """Whether some words are complete, so that a new command can follow them."""
    last, before = said[-1], said[-2] if len(said) > 1 else ""
    if _is_time(said) or (last == _AROUND and tags[-2:-1] == ["VERB"]):
        return True
    if last in _NEVER_LAST | _SUBJECTS | (OBJECT_BEGINNINGS - _OBJECT_PRONOUNS):
        return False
    verbs = {word for word, tag in zip(said, tags) if tag == "VERB"}
    if verbs & _WITH_A_VERB or not (verbs or _FORMS_OF_BE & frozenset(said)):
        return False
    is_predicate = tags[-1] == "ADJ" and before in _FORMS_OF_BE
    # "I want to sleep turn off the light" is two clauses; "I want to go get the mug" is one.
    is_infinitive = tags[-1] == "VERB" and before == "to" and last not in _LEADING_VERBS and last != "help"
    is_particle = tags[-1] == "ADP" and last in _PARTICLES and tags[-2:-1] != ["VERB"]
    return tags[-1] in _COMPLETE or is_predicate or is_infinitive or is_particle


def _is_time(said: Sequence[str]) -> bool:
    """Whether some words only say when: "every day at nine *close the blinds*"."""
    has_day = any(word in _TIMES for word in said)
    is_last = said[-1] in _TIMES or find_number(said[-1]) is not None
    return has_day and is_last and all(word in _TIMES | _OF_TIMES or find_number(word) is not None for word in said)


def _is_two_word_noun(first: str, second: str) -> bool:
    """Whether two words are one noun whose second word may also be a deed: "the night stand"."""
    together = f"{first} {second}"
    return bool(shipped_types().of_noun([together]).types)
