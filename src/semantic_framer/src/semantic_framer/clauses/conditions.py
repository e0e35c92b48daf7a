"""Reads clauses that say how things are ("the door is closed") by the states and events of lexical units.

A condition is read only if all of its words are understood. It is said in the present or the perfect; any other tense
or mood ("if the door was open", "if Anna should come") is not understood. A negation of the whole clause is taken out,
and kept beside the reading.
"""

from dataclasses import replace
from itertools import dropwhile
from typing import Dict, FrozenSet, List, Mapping, NamedTuple, Optional, Sequence

from semantic_framer.clauses.event_conditions import (
    event_condition,
    passive_condition,
    unit_condition,
)
from semantic_framer.clauses.held_states import state_condition
from semantic_framer.kinds.clause_features import features_among, features_of, top_among
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.word_patterns import heads
from semantic_framer.values.condition_part import ConditionPart, happens, is_momentary
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from utterance_passes.trees.tree import PHRASE_HEADS, VERBS, Word
from utterance_passes.trees.tree_edits import TreeEdit
from word_classes import word_class

_CONJUNCTIONS: Mapping[str, str] = {"and": "ALL", "or": "ANY"}
_DO = word_class("forms_of_do")
_NOT = word_class("not")
#: "Nobody", "nothing".
_DENIED = word_class("no_pronouns") & word_class("subject_pronouns")
_NOTHING = "nothing"
_ANYBODY = word_class("indefinite_persons_asked")
_WHO = word_class("relative_pronouns")
_STATE, _MESSAGE = "state", "message"
_PADDING = word_class("condition_padding")
_STATES = word_class("state_particles")
_OF_PLACES = word_class("place_prepositions") | word_class("to_prepositions")
_NO_PHRASE = (
    word_class("question_words")
    | word_class("conditions")
    | word_class("reason_conjunctions")
    | word_class("negations")
)
_FORMS_OF_BE = word_class("forms_of_be")
#: Universal tags of words that are in no noun phrase, and of words that may end one.
_NOPHRASE_HEADS = frozenset(["VERB", "AUX", "SCONJ", "INTJ"])
_OF_BARE_PHRASES = frozenset(["ADJ", "NOUN", "PROPN", "NUM"])
_ADJECTIVES = frozenset(["JJ", "VBN", "VBD", "JJR"])
_OF_MESSAGES = frozenset(["obj", "ccomp", "xcomp"])
_ALTERNATIVE = "either"


class _Words(NamedTuple):
    """The words of a clause that say something.

    Attributes:
        words: without negations, "again" and auxiliaries of the present and the perfect
        is_negated: whether a negation was taken out
        is_anew: whether an "again" was taken out
        renamed: what a word that denies or leaves open stands for, by its position: "somebody" for "nobody"
    """

    words: List[Word]
    is_negated: bool
    is_anew: bool
    renamed: Dict[int, str]


def is_auxiliary(word: Word) -> bool:
    """Whether a word may begin a question; "is" in "is there a mug" is a verb to the parser."""
    return word.upos == "AUX" or word.said in _FORMS_OF_BE


def read_condition(
    sentence: Sentence,
    known: FramedLexicon,
    positions: Sequence[int],
    *,
    is_until: bool = False,
    must_last: bool = False,
    is_of_the_past: bool = False,
    somebody: int = 0,
) -> Optional[ConditionPart]:
    """Read some words as a condition.

    Args:
        sentence: the sentence
        known: lexical units and frames
        positions: of the words, in order
        is_until: whether "until" stands before them, so that a place means to be there: "until the wall"
        must_last: whether "while" stands before them: what happens in a moment cannot go on
        is_of_the_past: whether the log is asked what the robot has done, also where a server watches the like: "if you
            have found the pen" is no wait until it sees one
        somebody: position of a word that means one of many: "greet *everybody* who comes in"; 0 for none
    Returns:
        None if one of the words is not understood
    """
    if _has_foreign_comma(sentence, positions):
        return None
    if somebody:
        one = _read_one(sentence, known, positions, is_until, somebody)
        return one if one is not None and happens(one, sentence.tree, known.frames) else None
    plain = [index for index in positions if sentence.word(index).upos != "PUNCT"]
    deed = _by_event(sentence, known, plain, is_of_the_past=True) if is_of_the_past else None
    read = deed or _read_whole(sentence, known, plain, is_until)
    return None if read is None or (must_last and is_momentary(read, known.frames)) else read


def read_asked(sentence: Sentence, known: FramedLexicon, positions: Sequence[int]) -> Optional[ConditionPart]:
    """Read what is asked for as a condition: "whether *the door is open*", "*is the door open*".

    Args:
        sentence: the sentence
        known: lexical units and frames
        positions: of the words, in order; the auxiliary at the front of a question is read behind the subject
    Returns:
        None if one of the words is not understood
    """
    if not positions or not is_auxiliary(sentence.word(positions[0])):
        return read_condition(sentence, known, positions)
    auxiliary, *rest = positions
    top = top_among(sentence.tree, positions)
    children = sentence.children(top) if top else ()
    subjects = [child.index for child in children if child.deprel == "expl"]
    subjects = subjects or [child.index for child in children if child.deprel.startswith("nsubj")]
    subject_words = frozenset().union(*(sentence.subtree(index) for index in subjects))
    # The words up to the end of the subject, first as the tree has it.
    ends = [len([index for index in rest if index in subject_words]), *range(1, len(rest) + 1)]
    for behind in ends:
        subject, predicate = rest[:behind], rest[behind:]
        condition = read_condition(sentence, known, [*subject, auxiliary, *predicate])
        if condition is not None:
            words = [sentence.text(subject), sentence.word(auxiliary).said, sentence.text(predicate)]
            return replace(condition, words=" ".join(words).strip())
    return None


def _has_foreign_comma(sentence: Sentence, positions: Sequence[int]) -> bool:
    """Whether a mark among some words does not stand between the items of a list: "when Anna comes, *greet her*"."""
    marks = [index for index in positions if sentence.word(index).upos == "PUNCT"]
    items = [index for index in positions if sentence.word(index).deprel == "conj"]
    return any(
        not any(item > mark > sentence.word(item).head and sentence.word(item).upos in PHRASE_HEADS for item in items)
        for mark in marks
    )


def _read_whole(
    sentence: Sentence, known: FramedLexicon, positions: Sequence[int], is_until: bool
) -> Optional[ConditionPart]:
    whole = _read_one(sentence, known, positions, is_until)
    if whole is not None:
        return whole
    joints = [index for index in positions if sentence.word(index).said in _CONJUNCTIONS]
    kinds = {_CONJUNCTIONS[sentence.word(index).said] for index in joints}
    if len(kinds) != 1:
        return None
    parts: List[List[int]] = [[]]
    for index in positions:
        if index in joints:
            parts.append([])
        else:
            parts[-1].append(index)
    found = [_read_one(sentence, known, part, is_until) for part in parts]
    read = tuple(part for part in found if part is not None)
    return ConditionPart(kinds.pop(), frozenset(positions), children=read) if len(read) == len(parts) else None


def _read_one(
    sentence: Sentence, known: FramedLexicon, positions: Sequence[int], is_until: bool, somebody: int = 0
) -> Optional[ConditionPart]:
    if positions and is_auxiliary(sentence.word(positions[0])):
        return None  # "When does Anna come" is a question.
    said = _words(sentence, positions, somebody)
    found = _by_trees(sentence, known, positions, said, is_until, somebody) if said is not None and said.words else []
    if said is None or not found:
        return None if somebody else _by_event(sentence, known, positions)
    best = max(found, key=lambda reading: len(reading.verb_positions))
    return _distributed(replace(best, clause_text=sentence.text(positions)), said, frozenset(positions))


def _by_event(
    sentence: Sentence, known: FramedLexicon, positions: Sequence[int], *, is_of_the_past: bool = False
) -> Optional[ConditionPart]:
    features = features_among(sentence.tree, positions)
    if features is None:
        return None
    event = event_condition(sentence, known, features, frozenset(positions), is_of_the_past=is_of_the_past)
    if event is None:
        return None
    return ConditionPart("CONDITION", frozenset(positions), event.reading, is_negated=event.is_negated)


def _by_trees(
    sentence: Sentence, known: FramedLexicon, positions: Sequence[int], said: _Words, is_until: bool, somebody: int
) -> List[Reading]:
    """Return the readings of a state and of what happens, with "somebody" for "nobody"."""
    words, renamed = frozenset(word.index for word in said.words), dict(said.renamed)
    if sentence.unquoted is not None and words & sentence.tree.quoted:
        # "Tell me if *the door opens*": what is said has no structure, and had one.
        sentence = sentence.unquoted
    for clause in sentence.children(somebody) if somebody in words else ():
        who = next((child for child in sentence.children(clause.index) if child.said in _WHO), None)
        if clause.deprel == "acl:relcl" and who is not None:
            # "Everybody *who comes in*."
            words, positions = words - {somebody} | {who.index}, sorted(sentence.subtree(clause.index))
            renamed[who.index] = "somebody"
    sentence = _with_message(sentence, known, said.words)
    features = features_among(sentence.tree, positions)
    if features is None and any(words <= time for time in sentence.tree.times):
        # "Eight in the evening."
        features = features_of(sentence.tree, min(words))
    if features is None:
        return []
    passive = passive_condition(sentence, known, features, frozenset(positions))
    if passive is not None:
        return [_renamed(passive, renamed)]
    found = [
        state_condition(sentence, known, features, words, is_until=is_until),
        unit_condition(sentence, known, features, words),
    ]
    whole = [one for one in found if one is not None and _are_phrases(sentence, one, renamed)]
    return [_renamed(reading, renamed) for reading in whole]


def _with_message(sentence: Sentence, known: FramedLexicon, words: Sequence[Word]) -> Sentence:
    """Return a sentence in which the word behind a verb of saying is its message: "until I say *stop*".

    What is said has no structure, so the parser hangs it anywhere.
    """
    events = replace(known, lexicon=known.lexicon.events)
    saying, message = words[-2:] if len(words) > 2 else (None, None)
    if saying is None or message is None or saying.upos != "VERB" or message.said in _NO_PHRASE:
        return sentence
    is_known = message.head == saying.index and message.deprel in _OF_MESSAGES
    units = events.units_of(saying.lemma.lower())
    if is_known or not any(relation.name == _MESSAGE for unit in units for relation in unit.relations):
        return sentence
    edit = TreeEdit(sentence.tree)
    if saying.index in sentence.subtree(message.index):
        edit.rehang(saying.index, message.head, message.deprel)
    edit.rehang(message.index, saying.index, "obj")
    return sentence.attached(edit.tree())


def _are_phrases(sentence: Sentence, reading: Reading, renamed: Mapping[int, str]) -> bool:
    """Whether what fills a condition are plain phrases and states, of which a server loses no word."""
    for argument in reading.arguments:
        if not argument.positions or argument.head_position in renamed or argument.time is not None:
            continue
        words = [sentence.word(index) for index in argument.positions]
        words = list(dropwhile(lambda word: word.upos in ("ADP", "PART"), words)) or words
        if argument.name == _MESSAGE and len(words) == 1:
            if words[0].said in _NO_PHRASE:
                return False
            continue  # "When I say *go*."
        if argument.name == _STATE:
            if not _is_state(words[0]):
                return False
        elif not (len(words) == 1 and words[0].upos == "ADV") and not _is_phrase(sentence, words):
            return False
    return True


def _renamed(reading: Reading, renamed: Mapping[int, str]) -> Reading:
    arguments = tuple(
        replace(argument, text=new, words=new, head=new, lemma=new) if new else argument
        for argument in reading.arguments
        for new in [renamed.get(argument.head_position, "")]
    )
    return replace(reading, arguments=arguments)


def _distributed(reading: Reading, said: _Words, positions: FrozenSet[int]) -> Optional[ConditionPart]:
    """Return a condition, or one for each item of a list: "if you see Anna or Bob"."""
    one = ConditionPart("CONDITION", positions, reading, is_negated=said.is_negated, is_anew=said.is_anew)
    lists = [argument for argument in reading.arguments if argument.separate_members]
    if not lists:
        return one
    kind = _CONJUNCTIONS.get(lists[0].conjunction)
    if len(lists) > 1 or kind is None or said.is_negated:
        return None  # "If Anna and Bob are not here" leaves open whether one of them may be.
    items = tuple(
        replace(
            one,
            reading=replace(
                reading,
                arguments=tuple(item if argument is lists[0] else argument for argument in reading.arguments),
            ),
        )
        for item in lists[0].separate_members
    )
    return ConditionPart(kind, positions, children=items)


def _words(sentence: Sentence, positions: Sequence[int], somebody: int = 0) -> Optional[_Words]:
    """Return the words of a clause that say something; None if its tense or mood is none of a condition."""
    words: List[Word] = []
    renamed: Dict[int, str] = {}
    negations = 0
    is_anew = False
    for index in positions:
        word = sentence.word(index)
        form = word.said
        if word.upos == "PUNCT" or index in sentence.tree.fillers:
            continue
        if form in _NOT or (form == "no" and word.deprel == "det"):
            negations += 1
        elif form == "again":
            is_anew = True
        elif (form in _PADDING and word.upos == "ADV") or _is_empty_auxiliary(sentence, word) or form == _ALTERNATIVE:
            continue
        else:
            is_denied = form == "one" and index > 1 and sentence.word(index - 1).said == "no"
            if is_denied:
                renamed[index] = "somebody"
            elif form in _DENIED:
                negations += 1
                renamed[index] = "something" if form == _NOTHING else "somebody"
            elif form in _ANYBODY or index == somebody:
                renamed[index] = "somebody"
            if index not in renamed and _is_of_the_past(sentence, word):
                return None
            words.append(word)
    return _Words(words, negations == 1, is_anew, renamed) if negations < 2 else None


def _is_empty_auxiliary(sentence: Sentence, word: Word) -> bool:
    """Whether a word only makes a form of the present or the perfect: "does", "has", "is coming"."""
    if word.deprel != "aux" or word.upos != "AUX":
        return False
    form, tag = word.said, sentence.tree.governor(word).xpos
    if word.xpos == "VBD":
        return False
    if form in _DO:
        return tag in ("VB", "VBP")
    if word.lemma.lower() == "have":
        return tag in ("VBN", "VBD")
    return word.lemma.lower() == "be" and tag == "VBG"


def _is_of_the_past(sentence: Sentence, word: Word) -> bool:
    """Whether a verb tells of the past: "if the door *was* open", but not "if it has *been* opened"."""
    if word.upos not in VERBS:
        return False
    children = sentence.children(word.index)
    is_perfect = any(
        child.deprel == "aux" and child.lemma.lower() == "have" and child.xpos != "VBD" for child in children
    )
    if word.lemma.lower() == "be":
        return not (word.xpos in ("VBZ", "VBP", "VB") or is_perfect or _follows_have(sentence, word))
    return word.xpos == "VBD" and not (is_perfect or any(child.deprel in ("aux:pass", "cop") for child in children))


def _follows_have(sentence: Sentence, word: Word) -> bool:
    """Whether "been" stands in a present perfect: "has been opened"."""
    around = sentence.children(word.head) if word.head else ()
    return word.xpos == "VBN" and any(
        other.lemma.lower() == "have" and other.deprel == "aux" and other.xpos != "VBD" for other in around
    )


def _is_state(word: Word) -> bool:
    form = word.said
    return form in _STATES or (word.upos in ("ADJ", "VERB") and word.xpos in _ADJECTIVES)


def _is_phrase(sentence: Sentence, words: Sequence[Word]) -> bool:
    """Whether words are one noun phrase, with phrases of place and of-phrases at most."""
    positions = [word.index for word in words]
    if any(word.upos in _NOPHRASE_HEADS and word.deprel not in ("amod", "compound") for word in words):
        return False
    if any(word.said in _NO_PHRASE - _DENIED for word in words):
        return False
    if not any(word.upos in PHRASE_HEADS for word in (words[0], words[-1])) and words[0].upos != "DET":
        return False
    is_list = any(word.deprel == "conj" and word.upos in PHRASE_HEADS and word.head in positions for word in words)
    if any(word.upos == "CCONJ" and not is_list for word in words) or any(map(_is_number_choice, words)):
        return False
    # "In the kitchen with Bob": only places tell which thing or place is meant.
    if any(word.upos == "ADP" and word.said not in _OF_PLACES for word in words[1:]):
        return False
    if words[0].upos == "ADP":
        return False
    if words[0].upos == "DET" and all(word.upos in _OF_BARE_PHRASES for word in words[1:]):
        # "The bell rings" is hardly a verb for the parser; an article makes a phrase of what follows.
        return len(words) > 1
    return len(heads(sentence.tree, positions)) == 1 and words[-1].upos in PHRASE_HEADS | {"ADV"}


def _is_number_choice(word: Word) -> bool:
    """Whether a number is one of several: "two or *three* persons"."""
    return word.upos == "NUM" and word.deprel == "conj"
