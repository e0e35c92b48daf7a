"""The last check of an utterance: no word of it is lost.

Each word of the text *as it was said* must be part of what was understood, of a formula around a command
(``formulas.yaml``), of its mood, or of the closed list of words that may go unread (``unread_words.yaml``). The check
knows the text, the words of the tree, and what the readings name. It knows no pass and no rule that made them, so no
pass can lose a word behind its back.
"""

import re
import unicodedata
from html import unescape
from typing import AbstractSet, FrozenSet, Iterable, List, Sequence, Set, Tuple

from semantic_framer.judging.rewritten_words import RUN, lost_in_rewriting, said_words, unread_length
from semantic_framer.judging.unread_words import shipped_unread_words
from semantic_framer.values.order_words import FIRST, LAST
from semantic_framer.values.reading import Reading
from semantic_types.parts_of_speech import VERB, parts_of_speech
from typed_arguments import TypedArgument
from utterance_passes.asides.objections import plain
from utterance_passes.deeds.avoided_places import CROSSING, PREPOSITION
from utterance_passes.trees.formula_file import KINDS, WRITTEN_OUT, pattern_of
from utterance_passes.trees.tree import ABANDONED, ASIDE, NOMINALS, DependencyTree, Word
from word_classes import word_class

#: Name of the check in the trace.
RULE = "said_words"
_OBJECTION, _FILLER = "objections", "fillers"
_FORMULAS = tuple(pattern_of(kind) for kind in KINDS if kind not in (_OBJECTION, _FILLER, WRITTEN_OUT))
_COMPARISONS = pattern_of("comparisons")
_OBJECTIONS = pattern_of(_OBJECTION)
#: The most words of a formula.
_LONGEST = 16
_ADDRESSED = word_class("robot_names") | word_class("those_addressed") | word_class("greetings")
_ARTICLES = word_class("articles")
_ASPECTUAL = word_class("aspectual_verbs")
_DOING = word_class("forms_of_do")
_AUXILIARIES = (
    word_class("modals") | word_class("polite_modals") | word_class("forms_of_be") | word_class("forms_of_do")
)
_CERTAIN = word_class("certain_adjectives")
_DIRECTIONS = word_class("all_directions")
_EACH = "each"
_BOTH = "both"
_THEY = "they"
_EXCLUDING = word_class("negations") | frozenset(["instead", "without"])
_FINITE = frozenset(["VBZ", "VBP"])
_FORMS_OF_BE = word_class("forms_of_be") | word_class("nonfinite_forms_of_be")
_OF_AMOUNTS = frozenset(["for", "by"])
_OF_STATEMENTS = word_class("whether_words") | frozenset(["that"])
_HEDGES = word_class("hedges")
_ORDER = word_class("adverbs_of_order")
_ONLY = word_class("restricting_adverbs")
_PADDING = word_class("padding")
_REASONS = word_class("reason_conjunctions")
_SUBJECTS = word_class("hearers") | word_class("speaker_subjects")
_FINDING = word_class("finding_verbs")
_TOLD = word_class("modals") | word_class("object_pronouns") | word_class("female_pronouns")
_UNFINISHED = word_class("only_before_nouns")
#: Verbs around the deed that a request is about.
AROUND_REQUESTS = word_class("request_verbs") | word_class("leading_verbs") | {"would", "be"}
_WISHES = AROUND_REQUESTS | word_class("causative_verbs") | word_class("verbs_of_duty")


def positions_named(readings: Iterable[Reading]) -> FrozenSet[int]:
    """Return the positions of all words that readings name: verbs, arguments, and how often or how long."""
    found: Set[int] = set()
    for reading in readings:
        found.update(reading.verb_positions, reading.control.positions)
        for argument in (*reading.arguments, *(reading.extra or ())):
            _add(argument, found)
    return frozenset(found)


def _add(argument: TypedArgument, found: Set[int]) -> None:
    found.update(argument.positions)
    found.update(one.position for one in argument.modifiers)
    for part in (argument.possessor, argument.complement, *argument.members, *argument.exceptions):
        if part is not None:
            _add(part, found)
    for frame in argument.frames:
        found.update(frame.positions)
        for element in frame.frame_elements:
            _add(element, found)


def words_left(
    tree: DependencyTree,
    readings: Sequence[Reading],
    others: AbstractSet[int] = frozenset(),
    *,
    is_asked: bool = False,
) -> Tuple[str, ...]:
    """Return the words as they were said that nothing accounts for, in order; none if no word is lost.

    Args:
        tree: the sentence that was understood, with its text as it was said
        readings: the best one of each clause that is done
        others: positions of words that no reading has, and that are understood: links, and what is only told
        is_asked: whether a person is asked something first, so that a phrase may be unfinished: "bring me the"
    """
    return _Check(tree, readings, others, is_asked).left()


class _Check:
    def __init__(
        self, tree: DependencyTree, readings: Sequence[Reading], others: AbstractSet[int], is_asked: bool
    ) -> None:
        self._tree = tree
        arguments = self._arguments = [argument for reading in readings for argument in reading.arguments]
        self._measured = frozenset(index for one in arguments if one.measure is not None for index in one.positions)
        self._lemmas = frozenset(lemma for one in arguments for lemma in _lemmas(one))
        self._is_asked = is_asked
        self._named = positions_named(readings) | others
        self._words = [word for word in tree.words if RUN.search(word.form)]
        self._forms = [word.said.replace("\u2019", "'") for word in self._words]
        self._forms_said = frozenset(one.form for one in said_words(tree.text))
        self._understood = self._named | self._opening() | self._excluded()
        self._covered = self._phrases() | self._understood

    def left(self) -> Tuple[str, ...]:
        """Return the words that nothing accounts for."""
        places = {
            one.start: self._tree.text[one.start : one.end]
            for one in lost_in_rewriting(self._tree, self._understood, self._named, self._lemmas)
        }
        places.update((word.start_character, word.form) for word in (*self._torn(), *self._denied()))
        for run in self._runs():
            places.update((word.start_character, word.form) for word in self._unread_of(run))
        return (*(places[place] for place in sorted(places)), *_signs(self._tree.text))

    def _torn(self) -> List[Word]:
        """Return the words of phrases of which a part fills another element: "the door *left* of you", "*an angle of*
        45 degrees"."""
        found: List[Word] = []
        for argument in self._arguments:
            inside = range(min(argument.positions, default=0), max(argument.positions, default=0))
            taken = {index for one in self._arguments if one is not argument for index in one.positions}
            words = [self._tree.word(index) for index in inside if index in taken - {*argument.positions}]
            found += [word for word in words if word.said in _DIRECTIONS]
            last = self._tree.word(max(argument.positions)) if argument.positions else None
            if last is not None and last.said == "of" and last.head in taken:
                found += [self._tree.word(index) for index in argument.positions]
        return found

    def _denied(self) -> List[Word]:
        """Return the words that deny a phrase that would be done, "follow me but *not* into the kitchen", and "each",
        which alone is no thing."""
        heads = {argument.head_position for argument in self._arguments if not argument.exceptions}
        found = [word for word in self._words if word.head and word.head in heads and self._denies(word)]
        alone = (argument for argument in self._arguments if len(argument.positions) == 1)
        words = [self._tree.word(index) for argument in alone for index in argument.positions]
        # "Visit the hall and the office, and after *both of them* the kitchen."
        members = [
            member
            for argument in self._arguments
            for member in argument.members
            if member.lemma == _THEY or member.text.lower() in FIRST | LAST
        ]
        both = [one for one in self._arguments if one.lemma == _BOTH and one.text.lower().startswith(_BOTH)]
        pairs = both + members
        found += [self._tree.word(index) for pair in pairs if not pair.referents for index in pair.positions]
        return found + [word for word in words if word.said == _EACH]

    def _denies(self, word: Word) -> bool:
        """Whether a word denies the noun on which it hangs, and no clause; an order of deeds is read elsewhere."""
        form, noun = word.said, self._tree.governor(word)
        if form == "no":
            return word.deprel == "discourse"
        behind = self._tree.words[word.index].said if word.index < len(self._tree.words) else ""
        is_clause = any(child.deprel == "cop" for child in self._tree.children(noun.index))
        is_denied = form == "not" and word.deprel == "advmod" and noun.upos in NOMINALS
        return is_denied and not is_clause and behind not in ("before", "after")

    def _phrases(self) -> FrozenSet[int]:
        """Return the positions of phrases that may go unread, and of comparisons, which hold words that are read."""
        found: Set[int] = set()
        for place in range(len(self._words)):
            length = shipped_unread_words().at(self._forms[place:])[1]
            texts = (" ".join(self._forms[place:end]) for end in range(place + 3, min(place + 9, len(self._words) + 1)))
            compared = next((len(text.split()) for text in texts if _COMPARISONS.fullmatch(text)), 0)
            if max(length, compared) > 1:
                found.update(word.index for word in self._words[place : place + max(length, compared)])
        return frozenset(found)

    def _opening(self) -> FrozenSet[int]:
        """Return the positions of the words that correct what was said before: "no, *I said* turn right"."""
        words = self._tree.words
        first = next((word.index for word in words if word.index in self._named), 0)
        said = " ".join(plain(word) for word in words[: max(0, first - 1)])
        return frozenset(range(1, first)) if _OBJECTIONS.fullmatch(said) else frozenset()

    def _excluded(self) -> FrozenSet[int]:
        """Return the positions of what is not to be done, up to a mark: "*do not bring me the red cup* but the blue
        one". It is not done."""
        found: Set[int] = set()
        for place, word in enumerate(self._words):
            if word.index in found or word.index in self._named or word.said not in _EXCLUDING:
                continue
            is_of_two = self._forms[place : place + 2] == ["instead", "of"]
            fronts = () if is_of_two else range(max(0, place - _LONGEST), place + 1)
            if any(front + _formula_length(self._forms[front:]) > place for front in fronts):
                continue  # "If you do *not* mind" forbids nothing.
            behind = self._tree.words[word.index - 1 :]
            ends = (one.index for one in behind if one.upos == "PUNCT" or one.said == "but")
            end = next(ends, len(self._tree.words) + 1)
            first = word.index - (word.index > 1 and self._tree.word(word.index - 1).said in _DOING)
            found.update(range(first, end))
        return frozenset(found)

    def _runs(self) -> Iterable[List[Word]]:
        """Yield the words between those that are understood."""
        run: List[Word] = []
        for word in self._words:
            if word.index not in self._covered:
                run.append(word)
            elif run:
                yield run
                run = []
        if run:
            yield run

    def _unread_of(self, run: List[Word]) -> List[Word]:
        """Return the words of a run that are no formula, no mood and no word that may go unread."""
        forms = [word.said.replace("\u2019", "'") for word in run]
        left: List[Word] = []
        place = 0
        while place < len(run):
            if self._is_reason(run[place:], forms[place:]):
                return left  # It is no deed.
            length = _formula_length(forms[place:]) or unread_length(forms[place:])
            if not length and not self._is_accounted_for(run[place]):
                left.append(run[place])
            place += length or 1
        return left

    def _is_reason(self, words: Sequence[Word], forms: Sequence[str]) -> bool:
        """Whether words say why something is done, or what speaks against it: a conjunction and a clause."""
        if forms[0] not in _REASONS and forms[:2] != ["so", "that"]:
            return False
        behind = self._tree.words[words[0].index :]
        if len(words) == 1:
            return bool(behind) and behind[0].index in self._named
        begins = behind[0].upos == "PRON" or any(word.upos == "AUX" for word in words)
        return begins or any(word.xpos in _FINITE and VERB in parts_of_speech(word.lemma.lower()) for word in words[1:])

    def _is_accounted_for(self, word: Word) -> bool:
        judges = (
            self._is_of_mood,
            self._is_of_argument,
            self._is_address,
            self._is_of_exclusion,
            self._is_of_order,
            self._is_of_named_things,
        )
        return word.deprel == ABANDONED or any(judge(word) for judge in judges)

    def _is_of_mood(self, word: Word) -> bool:
        """Whether a word only says of what kind a clause is: "*could you* go", "*I want you to* go", "*start* it"."""
        form, relation = word.said, word.deprel.split(":")[0]
        if (relation in ("aux", "cop") and form in _AUXILIARIES) or (relation == "nsubj" and form in _SUBJECTS):
            return True
        if form in _HEDGES:
            return True
        before = self._tree.word(word.index - 1).lemma.lower() if word.index > 1 else ""
        if form == "by" and before in _ASPECTUAL:
            return True
        behind = next((one for one in self._tree.words[word.index :] if one.said not in ("to", "by")), None)
        if behind is not None and behind.said in _CERTAIN:
            return True  # "*Make* sure".
        if word.lemma.lower() in _ASPECTUAL and behind is not None and behind.index in self._named:
            return True
        return word.lemma.lower() in _WISHES

    def _is_of_argument(self, word: Word) -> bool:
        """Whether a word belongs to words that are understood: "make *a* turn", "*for* an hour", "say *that* ..."."""
        form, is_of_named = word.said, word.head in self._named
        if form in _ARTICLES and word.deprel == "det" and is_of_named:
            return True
        if form in _OF_AMOUNTS and self._is_before_amount(word):
            return True
        if form in _OF_STATEMENTS and word.deprel == "mark" and is_of_named:
            return True
        if form in _FORMS_OF_BE | frozenset(["where"]) and is_of_named:
            return True
        if form in _TOLD and word.deprel == ASIDE and not _FINDING.isdisjoint(self._forms_said):
            return True  # "You *will* find *him* at the desk" says where he is.
        return self._is_asked and form in _UNFINISHED

    def _is_before_amount(self, word: Word) -> bool:
        behind = [one.index for one in self._tree.words[word.index : word.index + 2]]
        return not self._measured.isdisjoint(behind)

    def _is_address(self, word: Word) -> bool:
        """Whether a word calls the hearer."""
        if word.said in _ADDRESSED:
            return True
        words = self._tree.words
        beside = [*words[max(0, word.index - 2) : word.index - 1], *words[word.index : word.index + 1]]
        is_apart = any(one.upos == "PUNCT" for one in beside)
        # A name behind a noun, without a mark, is rather a part of what is named: "find my sister Anna".
        is_first = word.upos == "PROPN" and all(word.index < index for index in self._named)
        return word.deprel == "vocative" and (is_apart or is_first)

    def _is_of_exclusion(self, word: Word) -> bool:
        """Whether a word belongs to what is avoided: "without going *through* the hall", "*while* avoiding it"."""
        form = word.said
        behind = self._tree.words[word.index].lemma.lower() if word.index < len(self._tree.words) else ""
        is_excluded = any(one.said in _EXCLUDING for one in self._tree.words[: word.index])
        if (form in CROSSING and is_excluded) or (form == "while" and behind == PREPOSITION):
            return True
        return word.deprel == ASIDE and word.index in self._around_avoided()

    def _around_avoided(self) -> FrozenSet[int]:
        """Return the positions of the words around a place to avoid: "*stay out of* the hall *at all times*"."""
        words, found = self._tree.words, set()  # type: Sequence[Word], Set[int]
        for border in (word for word in words if word.said == PREPOSITION and word.deprel == "case"):
            inside = set(self._tree.subtree(border.head))
            for step in (-1, 1):
                index = border.index + step
                while 0 < index <= len(words) and (words[index - 1].deprel == ASIDE or index in inside):
                    found.add(index)
                    index += step
        return frozenset(found)

    def _is_of_order(self, word: Word) -> bool:
        """Whether a word puts a deed or a phrase behind the one before: "go to the hall, *next* greet Bob", "go to the
        hall, *after that* to the office"."""
        if word.index > word.head or word.head not in self._named:
            return False
        behind = self._tree.words[word.index].said
        if word.deprel == ASIDE and word.said in _ONLY and behind in _ORDER:
            return True  # "And *only then* the hall."
        is_adverb = word.said in _ORDER and word.deprel == "advmod"
        return is_adverb or (word.deprel == ASIDE and word.head in self._tree.sharing_a_verb)

    def _is_of_named_things(self, word: Word) -> bool:
        """Whether a word names things that are said one by one, too: "*two cups*, a red one and a blue one"."""
        is_number = word.upos in ("NUM", "DET") and word.index < len(self._tree.words)
        thing = self._tree.word(word.index + 1) if is_number else word
        is_left = thing.upos == "NOUN" and thing.deprel == ASIDE and thing.index not in self._named
        return is_left and thing.lemma.lower() in self._lemmas


def _signs(text: str) -> Tuple[str, ...]:
    """Return what no person says: invisible marks inside the text, and codes of web pages."""
    found = [f"U+{ord(sign):04X}" for sign in text.strip("\ufeff") if unicodedata.category(sign) in ("Cf", "Co", "Cn")]
    if unescape(text) != text:
        found += re.findall(r"&#?\w+;?", text)
    return tuple(dict.fromkeys(found))


def _formula_length(forms: Sequence[str]) -> int:
    for end in range(min(len(forms), _LONGEST), 0, -1):
        text = " ".join(forms[:end])
        padded = " ".join(form for form in forms[:end] if form not in _PADDING)
        if any(pattern.fullmatch(text) or (padded and pattern.fullmatch(padded)) for pattern in _FORMULAS):
            return end
    return 0


def _lemmas(argument: TypedArgument) -> Iterable[str]:
    yield argument.lemma
    for part in argument.members:
        yield from _lemmas(part)
