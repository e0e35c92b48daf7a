"""People who correct themselves: "turn left no right", "go to the kitchen, sorry, the office".

What was abandoned, and the words that say so, become a *reparandum* of the correction, as Universal Dependencies have
it; nothing that is read later looks at them. Where it is not certain what the correction replaces, the readings are
returned so that a person can be asked. Between the two stands an editing term (Shriberg, *Preliminaries to a theory of
speech disfluencies*, 1994).
"""

from dataclasses import replace
from typing import Dict, List, Optional, Sequence, Set, Tuple, Union

from stanford_parser_ros.tree import DependencyTree, Word

from semantic_framer.asides import set_aside
from semantic_framer.clauses import CONDITIONS, NEGATIONS
from semantic_framer.dialogue import Choice
from semantic_framer.lexicon import Lexicon
from semantic_framer.measures import Amount, find_amounts
from semantic_framer.sentence import Sentence, is_filler
from semantic_framer.times import find_times

#: Words that take back what was said before them, the longest first.
EDITING_TERMS: Tuple[Tuple[str, ...], ...] = (
    ("i", "mean"),
    ("i", "meant"),
    ("or", "rather"),
    ("no",),
    ("nope",),
    ("sorry",),
    ("correction",),
    ("rather",),
)
#: They take something back even where nothing follows.
_WITHDRAWING = frozenset([("no",), ("nope",)])
#: Said around an editing term.
_AROUND = frozenset("oh ah well wait actually please".split())
_BEFORE_NO_EDITING_TERM = ("VERB", "AUX", "ADP", "DET", "SCONJ", "CCONJ")
_IN_NAMES = ("DET", "ADJ", "NUM", "NOUN", "PROPN", "PRON")
_RELATION_IN_NAMES: Dict[str, str] = {"DET": "det", "ADJ": "amod", "NUM": "nummod", "ADP": "case", "PUNCT": "punct"}


class _Unresolved(Exception):
    """It is not certain what a correction replaces; ``choices`` are what may be meant."""

    def __init__(self, *choices: Choice) -> None:
        super().__init__()
        self.choices = choices


def repaired(tree: DependencyTree, lexicon: Lexicon) -> Union[DependencyTree, Tuple[Choice, ...]]:
    """Take what was corrected out of a sentence.

    Args:
        tree: the sentence
        lexicon: its verbs tell what is a command, and which words stand for each other ("left", "right")
    Returns:
        the sentence, with the same words in the same places; or, where it is not certain, the readings to choose from,
        none where all was taken back
    """
    tree = _without_restarts(tree)
    behind = 0
    while True:
        found = _editing_term(tree, lexicon, behind)
        if found is None:
            return tree
        start, end, is_withdrawing = found
        if end == len(tree.words) or all(word.upos == "PUNCT" for word in tree.words[end:]):
            if is_withdrawing:
                return ()
            return tree
        try:
            tree = _Repair(tree, lexicon, start, end).tree()
        except _Unresolved as unresolved:
            return unresolved.choices
        behind = end


def _without_restarts(tree: DependencyTree) -> DependencyTree:
    """Drop the first of a word that is said twice in a row: "turn turn left", "ninety uh ninety degrees".

    A number that is said twice without a filler is two digits, and "very very" means more.
    """
    said = [word for word in tree.words if not is_filler(word.form) and word.upos != "PUNCT"]
    for first, second in zip(said, said[1:]):
        is_restart = (
            first.form.lower() == second.form.lower()
            and first.upos not in ("ADV", "ADJ", "INTJ")
            and (first.upos != "NUM" or second.index > first.index + 1)
        )
        if not is_restart:
            continue
        first, second = tree.word(first.index), tree.word(second.index)
        words = [replace(word, head=second.index) if word.head == first.index else word for word in tree.words]
        if second.head == first.index:
            words[second.index - 1] = replace(second, head=first.head, deprel=first.deprel)
        words[first.index - 1] = replace(first, head=second.index, deprel="reparandum")
        changed = replace(tree, words=tuple(words))
        tree = changed if _is_tree(changed) else tree
    return tree


def _editing_term(tree: DependencyTree, lexicon: Lexicon, behind: int) -> Optional[Tuple[int, int, bool]]:
    """Find the first editing term behind a command: its first and last word with what is around it, and whether it takes
    back even where nothing follows.
    """
    forms = [word.form.lower() for word in tree.words]
    has_verb = False
    position = 0
    while position < len(forms):
        first = position
        terms: List[Tuple[str, ...]] = []
        while position < len(forms):
            term = next((term for term in EDITING_TERMS if tuple(forms[position : position + len(term)]) == term), None)
            is_around = forms[position] in _AROUND or is_filler(forms[position])
            if term is None and not is_around and tree.words[position].upos != "PUNCT":
                break
            terms += [term] if term else []
            position += len(term) if term else 1
        if terms and first >= behind and has_verb and _takes_back(tree, lexicon, first, position, terms):
            return first + 1, position, any(term in _WITHDRAWING for term in terms)
        if forms[first] in NEGATIONS and not terms:
            # "Don't turn left, I mean right" is left as it is: not to act is the safe reading.
            return None
        has_verb = has_verb or _is_verb(tree.words[first], lexicon)
        position = max(position, first + 1)
    return None


def _takes_back(
    tree: DependencyTree, lexicon: Lexicon, first: int, behind: int, terms: Sequence[Tuple[str, ...]]
) -> bool:
    """Whether a term stands between a command and a correction: "say no", "there is no chair" and "with no lid" do not
    take anything back, and in "bring Bob no mug" the word belongs to what follows.
    """
    if len(terms) > 1 or behind == len(tree.words):
        return len(terms) > 1 or tree.words[first - 1].upos not in _BEFORE_NO_EDITING_TERM
    if tree.words[first - 1].upos in _BEFORE_NO_EDITING_TERM:
        return False
    following = tree.words[behind]
    is_determiner = following.upos in ("NOUN", "ADJ") or following.form.lower() in ("one", "body")
    if tree.words[behind - 1].form.lower() == "no" and is_determiner:
        before = tree.words[:first]
        return any(_are_alternatives(word, following, before, lexicon) for word in before)
    return True


def _is_verb(word: Word, lexicon: Lexicon) -> bool:
    return word.upos == "VERB" and any(
        lexicon.verbs_beginning_with(spelling) for spelling in (word.lemma.lower(), word.form.lower())
    )


def _are_alternatives(said: Word, corrected: Word, before: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a unit of a verb that was said lists both words for the same element."""
    pair = {said.form.lower(), corrected.form.lower()}
    return any(
        pair <= set(relation.words)
        for verb in before
        if _is_verb(verb, lexicon)
        for name in lexicon.verbs_beginning_with(verb.lemma.lower())
        for unit in lexicon.units_of(name)
        for relation in unit.relations
        if relation.words
    )


class _Repair:
    """Puts one correction in the place of what it corrects."""

    def __init__(self, tree: DependencyTree, lexicon: Lexicon, start: int, end: int) -> None:
        self._tree = tree
        self._lexicon = lexicon
        self._term = frozenset(range(start, end + 1))
        gone = frozenset(word.index for word in tree.words if word.deprel == "reparandum")
        self._before = [word for word in tree.words[: start - 1] if word.index not in gone]
        self._after = list(tree.words[end:])
        self._gone = gone

    def tree(self) -> DependencyTree:
        """Return the corrected sentence.

        Raises:
            _Unresolved: it is not certain what is corrected
        """
        if _is_verb(self._after[0], self._lexicon):
            return self._with_another_command()
        correction, spans = self._candidates()
        if not correction or not spans:
            raise self._either()
        rest = [word for word in self._after if word not in correction]
        if len(spans) > 1:
            texts = [self._text(self._replaced(span, correction) + rest) for span in spans]
            trees = [self._rewired(span, correction) for span in spans]
            raise _Unresolved(*(Choice(text, tree) for text, tree in zip(texts, trees)))
        return self._rewired(spans[0], correction)

    def _either(self) -> _Unresolved:
        """Return that what was said before the term may be meant, or what was said behind it."""
        return _Unresolved(self._alone(self._before), self._alone(self._after))

    def _alone(self, words: Sequence[Word]) -> Choice:
        """Return the reading that is made of some of the words."""
        positions = frozenset(word.index for word in words)
        others = frozenset(word.index for word in self._tree.words) - positions
        return Choice(self._text(words), set_aside(self._tree, others, self._lexicon, "reparandum"))

    def _text(self, words: Sequence[Word]) -> str:
        positions = [word.index for word in words if word.upos != "PUNCT"]
        return Sentence(self._tree).text_in_order(positions)

    def _replaced(self, span: Sequence[Word], correction: Sequence[Word]) -> List[Word]:
        at = self._before.index(span[0])
        return [*self._before[:at], *correction, *(word for word in self._before[at:] if word not in span)]

    def _with_another_command(self) -> DependencyTree:
        """Replace the last command by another one: "turn left no turn right"."""
        verbs = [word for word in self._before if _is_verb(word, self._lexicon)]
        new = self._after[0]
        same = [verb for verb in verbs if verb.lemma.lower() == new.lemma.lower()]
        if len(verbs) > 1 and same != [verbs[-1]]:
            last = self._before.index(verbs[-1])
            raise _Unresolved(self._alone(self._before[:last] + self._after), self._alone(self._after))
        start = 0 if len(verbs) == 1 else self._before.index(verbs[-1])
        if self._is_put_off(self._before[start:]):
            # The condition, or the time, may have been meant for both.
            raise self._either()
        return self._rewired(self._before[start:], self._after, old_head=verbs[-1], new_head=new)

    def _is_put_off(self, words: Sequence[Word]) -> bool:
        """Whether words hold a condition or a time."""
        positions = frozenset(word.index for word in words)
        return any(word.form.lower() in CONDITIONS for word in words) or any(
            time & positions for time in find_times(Sentence(self._tree))
        )

    def _candidates(self) -> Tuple[List[Word], List[List[Word]]]:
        """Return the correction, and what of the same kind was said before it."""
        first = self._after[0]
        is_preposition = first.upos == "ADP"
        listed = [
            word
            for word in ([] if is_preposition else self._before)
            if _are_alternatives(word, first, self._before, self._lexicon)
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
            same = [phrase for phrase in phrases if phrase[0].form.lower() == first.form.lower()]
            return ([first] + name if name else []), same or phrases
        name = _name_at(self._after)
        names = _names(self._before)
        return name, [other for other in names if name and _is_person(other) == _is_person(name)]

    def _amounts(self, words: Sequence[Word]) -> Tuple[Amount, ...]:
        return find_amounts(Sentence(self._tree), [word.index for word in words])

    def _amount_spans(self, amount: Amount) -> List[List[Word]]:
        spans = []
        for other in self._amounts(self._before):
            if not amount.unit and other.unit:
                # "Two metres no three": the unit stays, but the number cannot be put before it.
                number = [position for position in other.positions if position != other.unit_position]
                text = self._text(self._replaced(self._words(number), self._words(amount.positions)))
                raise _Unresolved(Choice(text, self._with_number(number, amount)))
            elif other.quantity == amount.quantity or not other.unit:
                spans.append(self._words(other.positions))
        return spans

    def _with_number(self, old: Sequence[int], amount: Amount) -> DependencyTree:
        """Return the sentence with a number, in digits, in the place of the first word of another one."""
        kept = frozenset(word.index for word in self._before) - frozenset(old[1:])
        others = frozenset(word.index for word in self._tree.words) - kept
        tree = set_aside(self._tree, others, self._lexicon, "reparandum")
        words = list(tree.words)
        digits = amount.digits()
        words[old[0] - 1] = replace(words[old[0] - 1], form=digits, lemma=digits, upos="NUM", xpos="CD")
        return replace(tree, words=tuple(words))

    def _words(self, positions: Sequence[int]) -> List[Word]:
        return [self._tree.word(position) for position in positions]

    def _rewired(
        self,
        span: Sequence[Word],
        correction: Sequence[Word],
        old_head: Optional[Word] = None,
        new_head: Optional[Word] = None,
    ) -> DependencyTree:
        """Hang a correction where its span hung, and the span and the term on the correction.

        Raises:
            _Unresolved: no tree comes of it
        """
        old, new = old_head or _head(span), new_head or _head(correction)
        dropped = {word.index for word in span} | self._term | self._gone
        inside = {word.index for word in correction}
        top = old
        while top.head in dropped | inside:
            top = self._tree.word(top.head)
        verb = next((word for word in self._before if _is_verb(word, self._lexicon) and word not in span), new)
        root = next(word for word in self._tree.words if word.head == 0)
        is_root_lost = top.head and (root.index in dropped or root in self._after)
        words = []
        for word in self._tree.words:
            if word.index == new.index:
                is_adverb = old.upos == "ADV" and len(correction) == 1
                word = replace(word, upos="ADV", xpos=old.xpos) if is_adverb else word
                words.append(replace(word, head=top.head, deprel=top.deprel))
            elif word.index in dropped:
                words.append(replace(word, head=new.index, deprel="reparandum"))
            elif is_root_lost and word.index == verb.index:
                words.append(replace(word, head=0, deprel="root"))
            elif word.index in inside and word.head not in inside:
                relation = word.deprel if old_head else _RELATION_IN_NAMES.get(word.upos, "compound")
                words.append(_below(word, new, relation))
            elif word.head in self._term or (is_root_lost and word.head == 0):
                words.append(_below(word, verb, word.deprel))
            elif word.head in dropped:
                words.append(replace(word, head=new.index))
            else:
                words.append(word)
        tree = replace(self._tree, words=tuple(words))
        if not _is_tree(tree):
            raise self._either()
        return tree


def _below(word: Word, governor: Word, deprel: str) -> Word:
    is_clause = word.upos == "VERB" and deprel not in ("xcomp", "ccomp", "advcl", "acl")
    return replace(word, head=governor.index, deprel="conj" if is_clause else "dep" if deprel == "root" else deprel)


def _head(words: Sequence[Word]) -> Word:
    """Return the word that the others hang on: the last of those that hang on a word outside, nouns before others."""
    inside = {word.index for word in words}
    outer = [word for word in words if word.head not in inside]
    nouns = [word for word in outer if word.upos in ("NOUN", "PROPN", "PRON")]
    return (nouns or outer or list(words))[-1]


def _name_at(words: Sequence[Word]) -> List[Word]:
    """Return the words of a name or a noun with what belongs to it, at the front of some words."""
    found: List[Word] = []
    for word in words:
        has_noun = any(other.upos in ("NOUN", "PROPN", "PRON") and other.xpos != "PRP$" for other in found)
        is_genitive = word.xpos == "POS" or (bool(found) and found[-1].xpos == "POS")
        is_next = bool(found) and word.index != found[-1].index + 1
        starts_anew = has_noun and not is_genitive and word.upos not in ("NOUN", "PROPN")
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


def _is_tree(tree: DependencyTree) -> bool:
    """Whether every word hangs on the one root."""
    if sum(1 for word in tree.words if word.head == 0) != 1:
        return False
    for word in tree.words:
        seen: Set[int] = set()
        while word.head:
            if word.index in seen:
                return False
            seen.add(word.index)
            word = tree.word(word.head)
    return True
