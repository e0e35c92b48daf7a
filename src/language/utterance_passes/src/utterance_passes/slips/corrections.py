"""Applies the corrections of speakers: "turn left no right", "go to the kitchen, sorry, the office".

An editing term separates the abandoned words from the correction (Shriberg, *Preliminaries to a theory of speech
disfluencies*, 1994). The abandoned words and the editing term become a *reparandum* of the correction, as in Universal
Dependencies; later steps ignore them. If it is not certain what the correction replaces, a person chooses a reading.
"""

from functools import lru_cache
from typing import Dict, FrozenSet, List, Optional, Sequence, Tuple

from utterance_passes.engine.utterance_pass import Choice, Example, Kind, Uncertain, tree_pass
from utterance_passes.phrases.amounts import SIGNS
from utterance_passes.phrases.measures import Amount, find_amounts
from utterance_passes.phrases.times import find_times
from utterance_passes.trees.formula_file import is_filler, pattern_of
from utterance_passes.trees.tree import ABANDONED, NOMINALS, NOUNS, DependencyTree, Word
from utterance_passes.trees.tree_edits import NotATree, TreeEdit, set_aside
from utterance_passes.trees.vocabulary import Verbs, Vocabulary, is_verb
from word_classes import word_class

_AROUND = word_class("around_objections")
_CONDITIONS = word_class("conditions")
_NEGATIONS = word_class("negations")
#: Terms that take something back even if nothing follows.
_WITHDRAWAL = pattern_of("withdrawals")
_EDITING_TERMS = (pattern_of("editing_terms"), _WITHDRAWAL)
#: The most words of an editing term.
_LONGEST_TERM = 2
_BEFORE_NO_EDITING_TERM = ("VERB", "AUX", "ADP", "DET", "SCONJ", "CCONJ")
_IN_NAMES = ("DET", "ADJ", "NUM", "NOUN", "PROPN", "PRON")
_RELATION_IN_NAMES: Dict[str, str] = {"DET": "det", "ADJ": "amod", "NUM": "nummod", "ADP": "case", "PUNCT": "punct"}


@tree_pass(
    Kind.DISFLUENCY,
    Example(
        "turn|VERB|0|root left|ADV|1|advmod|left|RB no|DET|4|det right|NOUN|1|obj|right|NN",
        (
            "left: advmod(turn) -> reparandum(right)",
            "no: det(right) -> reparandum(right)",
            "right: obj(turn) NOUN/right -> advmod(turn) ADV/right",
        ),
        Verbs(frozenset(["turn", "go"]), lists={"turn": (("left", "right"),)}),
    ),
    assigns=[ABANDONED, *"root parataxis conj dep advmod det amod nummod case punct compound".split()],
)
def corrections(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Replace the corrected words by the correction; ask if it is not certain which words those are.

    The corrected words stay in the text.

    Raises:
        Uncertain: it is not certain what the correction replaces; holds the readings to choose from, or none if the
            speaker took everything back
    """
    behind = 0
    while True:
        found = _editing_term(tree, vocabulary, behind)
        if found is None:
            return tree
        start, end, is_withdrawing = found
        if end == len(tree.words) or all(word.upos == "PUNCT" for word in tree.words[end:]):
            if is_withdrawing:
                raise Uncertain()
            return tree
        tree = _Repair(tree, vocabulary, start, end).tree()
        behind = end


@tree_pass(
    Kind.DISFLUENCY,
    Example(
        "turn|VERB|0|root turn|VERB|1|xcomp left|ADV|2|advmod",
        ("turn: root -> reparandum(turn-2)", "turn: xcomp(turn-1) -> root"),
    ),
    assigns=[ABANDONED],
)
def restarts(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Drop the first of two equal words in a row: "turn turn left", "ninety uh ninety degrees".

    A repeated number without a filler is two digits, also with a comma between figures: "5,5" may mean 5.5. A repeated
    sign may mean the contrary: "minus minus 4". "Very very" is an emphasis.
    """
    if len(tree.forms) == len(tree.words):
        return tree
    said = [word for word in tree.words if not is_filler(word.form) and word.upos != "PUNCT"]
    for first, second in zip(said, said[1:]):
        is_restart = (
            first.said == second.said
            and first.upos not in ("ADV", "ADJ", "INTJ")
            and (not _is_of_a_number(first) or _is_number_said_again(tree, first, second))
        )
        if not is_restart:
            continue
        first, second = tree.word(first.index), tree.word(second.index)
        edit = TreeEdit(tree)
        edit.rehang_children(first.index, second.index)
        if second.head == first.index:
            edit.rehang(second.index, first.head, first.deprel)
        edit.rehang(first.index, second.index, ABANDONED)
        try:
            tree = edit.tree()
        except NotATree:
            continue
    return tree


def _is_of_a_number(word: Word) -> bool:
    return word.upos == "NUM" or word.said in SIGNS


def _is_number_said_again(tree: DependencyTree, first: Word, second: Word) -> bool:
    between = tree.words[first.index : second.index - 1]
    return any(is_filler(word.form) for word in between) or (bool(between) and first.form.isalpha())


def _editing_term(tree: DependencyTree, vocabulary: Vocabulary, behind: int) -> Optional[Tuple[int, int, bool]]:
    """Find the first editing term after a command: the first and last word of the term and the words around it, and
    whether it takes something back even if nothing follows.
    """
    forms = [word.said for word in tree.words]
    has_verb = False
    position = 0
    while position < len(forms):
        first = position
        terms: List[str] = []
        while position < len(forms):
            term = _term_at(forms, position)
            is_around = forms[position] in _AROUND or is_filler(forms[position])
            if not term and not is_around and tree.words[position].upos != "PUNCT":
                break
            terms += [term] if term else []
            position += len(term.split()) if term else 1
        is_new = first >= behind and any(word.deprel != ABANDONED for word in tree.words[first:position])
        if terms and is_new and has_verb and _takes_back(tree, vocabulary, first, position, terms):
            return first + 1, position, any(_WITHDRAWAL.fullmatch(term) for term in terms)
        if forms[first] in _NEGATIONS and not terms:
            # "Don't turn left, I mean right" stays as it is: it is safe not to act.
            return None
        has_verb = has_verb or _is_verb(tree.words[first], vocabulary)
        position = max(position, first + 1)
    return None


def _term_at(forms: Sequence[str], position: int) -> str:
    """Return the longest editing term at a position; empty if there is none."""
    for length in range(_LONGEST_TERM, 0, -1):
        said = " ".join(forms[position : position + length])
        if _is_term(said):
            return said
    return ""


@lru_cache(maxsize=4096)
def _is_term(said: str) -> bool:
    return any(pattern.fullmatch(said) for pattern in _EDITING_TERMS)


def _takes_back(tree: DependencyTree, vocabulary: Vocabulary, first: int, behind: int, terms: Sequence[str]) -> bool:
    """Whether a term separates a command from a correction. It takes nothing back in "say no", "there is no chair" and
    "with no lid"; in "bring Bob no mug", it belongs to the next word.
    """
    if len(terms) > 1 or behind == len(tree.words):
        return len(terms) > 1 or tree.words[first - 1].upos not in _BEFORE_NO_EDITING_TERM
    following = tree.words[behind]
    if [word.said for word in tree.words[behind + 1 : behind + 2]] == ["than"]:
        return False  # "No further than two metres" is a bound.
    if tree.words[first - 1].upos in ("DET", "ADP") and _is_verb(following, vocabulary):
        # "Bring me the no bring me the cup": nobody says "the no", so the phrase breaks off.
        return True
    if tree.words[first - 1].upos in _BEFORE_NO_EDITING_TERM:
        return False
    is_determiner = following.upos in ("NOUN", "ADJ") or following.said in ("one", "body")
    if tree.words[behind - 1].said == "no" and is_determiner:
        before = tree.words[:first]
        return any(_are_alternatives(word, following, before, vocabulary) for word in before)
    return True


def _is_verb(word: Word, vocabulary: Vocabulary) -> bool:
    return word.upos == "VERB" and is_verb(vocabulary, word)


def _are_alternatives(said: Word, corrected: Word, before: Sequence[Word], vocabulary: Vocabulary) -> bool:
    """Whether a unit of one of the verbs lists both words for the same element."""
    pair = {said.said, corrected.said}
    return any(
        pair <= set(listed)
        for verb in before
        if _is_verb(verb, vocabulary)
        for name in vocabulary.verbs_beginning_with(verb.lemma.lower())
        for listed in vocabulary.lists_of(name)
    )


class _Repair:
    """Replaces the corrected words by one correction."""

    def __init__(self, tree: DependencyTree, vocabulary: Vocabulary, start: int, end: int) -> None:
        self._tree = tree
        self._vocabulary = vocabulary
        self._term = frozenset(range(start, end + 1))
        gone = frozenset(word.index for word in tree.words if word.deprel == ABANDONED)
        self._before = [word for word in tree.words[: start - 1] if word.index not in gone]
        self._after = list(tree.words[end:])
        self._gone = gone

    def tree(self) -> DependencyTree:
        """Return the corrected sentence.

        Raises:
            Uncertain: it is not certain what the speaker corrects
        """
        if _is_verb(self._after[0], self._vocabulary):
            return self._with_another_command()
        recounted = self._recounted()
        if recounted is not None:
            return recounted
        correction, spans = self._candidates()
        if not correction or not spans:
            raise self._either()
        rest = [word for word in self._after if word not in correction]
        if len(spans) > 1:
            texts = [self._text(self._replaced(span, correction) + rest) for span in spans]
            trees = [self._rewired(span, correction) for span in spans]
            raise Uncertain(*(Choice(text, tree) for text, tree in zip(texts, trees)))
        return self._rewired(spans[0], correction)

    def _recounted(self) -> Optional[DependencyTree]:
        """Return the sentence with another number of the same things: "bring me three apples, make that four"."""
        said = [word for word in self._after if word.upos != "PUNCT"]
        counts = [word.index for word in self._before if word.upos == "NUM" and word.deprel == "nummod"]
        number = self._amounts(self._after)
        if len(said) != 1 or said[0].upos != "NUM" or len(counts) != 1 or len(number) != 1:
            return None
        is_measure = any(amount.unit for amount in self._amounts(self._before))
        return None if is_measure else self._with_number(counts, number[0])

    def _either(self) -> Uncertain:
        """Return the choice between the words before the term and the words after it."""
        return Uncertain(self._alone(self._before), self._alone(self._after))

    def _alone(self, words: Sequence[Word]) -> Choice:
        """Return the reading that keeps only some of the words."""
        positions = frozenset(word.index for word in words)
        others = frozenset(word.index for word in self._tree.words) - positions
        return Choice(self._text(words), self._without(others))

    def _without(self, positions: FrozenSet[int]) -> DependencyTree:
        return set_aside(self._tree, positions, ABANDONED, lambda word: is_verb(self._vocabulary, word))

    def _text(self, words: Sequence[Word]) -> str:
        positions = [word.index for word in words if word.upos != "PUNCT"]
        return self._tree.text_in_order(positions)

    def _replaced(self, span: Sequence[Word], correction: Sequence[Word]) -> List[Word]:
        at = self._before.index(span[0])
        return [*self._before[:at], *correction, *(word for word in self._before[at:] if word not in span)]

    def _with_another_command(self) -> DependencyTree:
        """Replace the last command by another one: "turn left no turn right"."""
        verbs = [word for word in self._before if _is_verb(word, self._vocabulary)]
        new = self._after[0]
        same = [verb for verb in verbs if verb.lemma.lower() == new.lemma.lower()]
        if len(verbs) > 1 and same != [verbs[-1]]:
            last = self._before.index(verbs[-1])
            raise Uncertain(self._alone(self._before[:last] + self._after), self._alone(self._after))
        start = 0 if len(verbs) == 1 else self._before.index(verbs[-1])
        if self._is_put_off(self._before[start:]):
            # The speaker may have meant the condition, or the time, for both commands.
            raise self._either()
        return self._rewired(self._before[start:], self._after, old_head=verbs[-1], new_head=new)

    def _is_put_off(self, words: Sequence[Word]) -> bool:
        """Whether some words contain a condition or a time."""
        positions = frozenset(word.index for word in words)
        return any(word.said in _CONDITIONS for word in words) or any(
            time & positions for time in find_times(self._tree)
        )

    def _candidates(self) -> Tuple[List[Word], List[List[Word]]]:
        """Return the correction, and the phrases of the same kind before it."""
        first = self._after[0]
        is_preposition = first.upos == "ADP"
        listed = [
            word
            for word in ([] if is_preposition else self._before)
            if _are_alternatives(word, first, self._before, self._vocabulary)
        ]
        if listed:
            return [first], [[word] for word in listed]
        amounts = self._amounts(self._after)
        if amounts and amounts[0].positions[0] == first.index:
            return self._words(amounts[0].positions), self._amount_spans(amounts[0])
        if is_preposition:
            name = _name_at(self._after[1:])
            phrases = [
                [word] + _name_at(self._before[index + 1 :])
                for index, word in enumerate(self._before)
                if word.upos == "ADP" and _name_at(self._before[index + 1 :])
            ]
            same = [phrase for phrase in phrases if phrase[0].said == first.said]
            return ([first] + name if name else []), same or phrases
        name = _name_at(self._after)
        names = _names(self._before)
        return name, [other for other in names if name and _is_person(other) == _is_person(name)]

    def _amounts(self, words: Sequence[Word]) -> Tuple[Amount, ...]:
        return find_amounts(self._tree, [word.index for word in words])

    def _amount_spans(self, amount: Amount) -> List[List[Word]]:
        spans = []
        for other in self._amounts(self._before):
            if not amount.unit and other.unit:
                # "Two metres no three": the unit stays, but the new number cannot move in front of it.
                number = [position for position in other.positions if position != other.unit_position]
                text = self._text(self._replaced(self._words(number), self._words(amount.positions)))
                raise Uncertain(Choice(text, self._with_number(number, amount)))
            if other.quantity == amount.quantity or not other.unit:
                spans.append(self._words(other.positions))
        return spans

    def _with_number(self, old: Sequence[int], amount: Amount) -> DependencyTree:
        """Return the sentence with the old number replaced by an amount in digits."""
        kept = frozenset(word.index for word in self._before) - frozenset(old[1:])
        others = frozenset(word.index for word in self._tree.words) - kept
        edit = TreeEdit(self._without(others))
        edit.respell(old[0], amount.digits())
        edit.retag(old[0], "NUM", "CD")
        return edit.tree()

    def _words(self, positions: Sequence[int]) -> List[Word]:
        return [self._tree.word(position) for position in positions]

    def _rewired(
        self,
        span: Sequence[Word],
        correction: Sequence[Word],
        old_head: Optional[Word] = None,
        new_head: Optional[Word] = None,
    ) -> DependencyTree:
        """Attach a correction to the head of the span that it replaces, and attach the span and the term to it.

        Raises:
            Uncertain: the result is not a tree
        """
        old, new = old_head or _head(span), new_head or _head(correction)
        dropped = {word.index for word in span} | self._term | self._gone
        inside = {word.index for word in correction}
        top = old
        while top.head in dropped | inside:
            top = self._tree.governor(top)
        verb = next((word for word in self._before if _is_verb(word, self._vocabulary) and word not in span), new)
        root = next(word for word in self._tree.words if word.head == 0)
        is_root_lost = top.head and (root.index in dropped or root in self._after)
        edit = TreeEdit(self._tree)
        for word in self._tree.words:
            if word.index == new.index:
                if old.upos == "ADV" and len(correction) == 1:
                    edit.retag(word.index, "ADV", old.xpos)
                edit.rehang(word.index, top.head, top.deprel)
            elif word.index in dropped:
                edit.rehang(word.index, new.index, ABANDONED)
            elif is_root_lost and word.index == verb.index:
                edit.rehang(word.index, 0, "root")
            elif word.index in inside and word.head not in inside:
                relation = word.deprel if old_head else _RELATION_IN_NAMES.get(word.upos, "compound")
                edit.rehang(word.index, new.index, _relation_below(word, relation))
            elif word.head in self._term or (is_root_lost and word.head == 0):
                edit.rehang(word.index, verb.index, _relation_below(word, word.deprel))
            elif word.head in dropped:
                edit.rehang(word.index, new.index)
        try:
            return edit.tree()
        except NotATree as error:
            raise self._either() from error


def _relation_below(word: Word, deprel: str) -> str:
    is_clause = word.upos == "VERB" and deprel not in ("xcomp", "ccomp", "advcl", "acl")
    return "conj" if is_clause else "dep" if deprel == "root" else deprel


def _head(words: Sequence[Word]) -> Word:
    """Return the head of some words: the last noun, or else the last word, whose own head is outside."""
    inside = {word.index for word in words}
    outer = [word for word in words if word.head not in inside]
    nouns = [word for word in outer if word.upos in NOMINALS]
    return (nouns or outer or list(words))[-1]


def _name_at(words: Sequence[Word]) -> List[Word]:
    """Return the name or noun phrase at the front of some words; empty if there is none."""
    found: List[Word] = []
    for word in words:
        has_noun = any(other.upos in NOMINALS and other.xpos != "PRP$" for other in found)
        is_genitive = word.xpos == "POS" or (bool(found) and found[-1].xpos == "POS")
        is_next = bool(found) and word.index != found[-1].index + 1
        starts_anew = has_noun and not is_genitive and word.upos not in NOUNS
        after_genitive = any(other.xpos == "POS" for other in found) and word.upos in ("ADJ", "NUM")
        if is_next or word.upos not in _IN_NAMES + ("PART",) or (word.upos == "PART" and word.xpos != "POS"):
            break
        if (starts_anew and not after_genitive) or (word.xpos == "PRP" and found):
            break
        found.append(word)
        if word.xpos == "PRP":
            break
    is_name = any(word.upos in ("NOUN", "PROPN", "PRON", "ADJ", "NUM") for word in found)
    return found if is_name else []


def _names(words: Sequence[Word]) -> List[List[Word]]:
    found: List[List[Word]] = []
    position = 0
    while position < len(words):
        name = _name_at(words[position:])
        if name:
            found.append(name)
        position += max(len(name), 1)
    return found


def _is_person(name: Sequence[Word]) -> bool:
    return name[-1].upos in ("PROPN", "PRON")
