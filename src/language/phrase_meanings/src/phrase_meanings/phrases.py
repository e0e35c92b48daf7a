"""Makes the typed argument of a phrase: relation, quantifier, count, modifiers, parts and descriptions of its head."""

from dataclasses import replace
from typing import Callable, Dict, FrozenSet, Iterable, List, NamedTuple, Optional, Sequence, Tuple

from phrase_meanings.arguments import of_same_kind
from phrase_meanings.head_words import (
    ONES,
    chosen_from,
    is_plural,
    is_side_of_something,
    located_there,
    modifiers,
    quantity,
    shares_noun,
)
from phrase_meanings.meaning_file import shipped_meanings
from semantic_frames.lexical_unit import ArgumentForm
from typed_arguments import EmbeddedFrame, TypedArgument
from utterance_passes.trees.tree import NOMINALS, QUOTATION_MARKS, VERBS, DependencyTree, Word
from word_classes import word_class

#: Relations of words at the front of a phrase that are not part of it.
_BEFORE_A_PHRASE = frozenset(["cc", "discourse", "mark"])
#: Prepositions that may introduce a verb.
_OF_VERBS = frozenset(["by"])
_COMPLEX_PREPOSITIONS = word_class("complex_prepositions")
_DEMONSTRATIVES = word_class("pronouns_of_things")
_LEFT_AND_RIGHT = word_class("left_and_right")
_NEGATIONS = word_class("negations")
_PLACE_PREPOSITIONS = word_class("place_prepositions")
_POSTURES = word_class("posture_verbs")
_QUESTION_WORDS = word_class("question_words")
_RELATIVE_WORDS = word_class("relative_pronouns") | word_class("relative_adverbs")
#: FrameNet's frame of "the box near the lamp", with the elements for the box and for the lamp.
_BEING_LOCATED, _THEME, _LOCATION = "being_located", "theme", "location"
_ADDING = frozenset(["as", "but"])
_BEFORE_LISTS = word_class("words_before_lists")
_ORDER = word_class("adverbs_of_order") | word_class("padding")
_CLITICS = frozenset(["'s", "'", "’s", "’"])


class _Extent(NamedTuple):
    """The words of a phrase.

    Attributes:
        positions: of all words, ascending
        prepositions: those of its prepositions; they belong to the relation, not to the text
    """

    positions: Tuple[int, ...]
    prepositions: FrozenSet[int]

    @property
    def bare(self) -> List[int]:
        """The positions without prepositions."""
        return [index for index in self.positions if index not in self.prepositions]


class _Plain(NamedTuple):
    """The attributes of an argument that say which words it has, and not yet what they mean."""

    name: str
    text: str
    words: str
    positions: Tuple[int, ...]


class Phrases:
    """Makes the arguments of the phrases of one tree; a phrase that several lexical units ask for is read once."""

    def __init__(self, tree: DependencyTree, semantic_type: Callable[[int], str] = lambda head: "") -> None:
        """
        Args:
            tree: the sentence
            semantic_type: returns the semantic type of a phrase, by the position of its head; empty if it is unknown
        """
        self._tree = tree
        self._semantic_type = semantic_type
        self._known: Dict[object, TypedArgument] = {}

    def argument(
        self,
        name: str,
        head: int,
        form: ArgumentForm = ArgumentForm.PHRASE,
        left_out: FrozenSet[int] = frozenset(),
        attached: FrozenSet[int] = frozenset(),
    ) -> TypedArgument:
        """Make the argument of a frame element.

        Args:
            name: name of the frame element
            head: position of the head word
            form: which words become the text
            left_out: positions of words that belong to something else
            attached: positions of words that belong to the phrase although the tree attaches them elsewhere
        Returns:
            the argument; its positions include a preposition at the front, but its text does not
        """
        # Only words below the head can be left out of it.
        key = (name, head, form, left_out & self._tree.subtree(head), attached)
        if key not in self._known:
            self._known[key] = self._argument(name, head, form, left_out, attached)
        return self._known[key]

    def _argument(
        self, name: str, head: int, form: ArgumentForm, left_out: FrozenSet[int], attached: FrozenSet[int]
    ) -> TypedArgument:
        tree = self._tree
        left_out |= tree.abandoned | tree.fillers - {head} | _said_around(tree, head)
        extent = _extent(tree, head, left_out, attached)
        plain = self._plain(head, extent, form, name)
        try:
            return self._described(plain, head, extent, left_out, attached, form)
        except ValueError:
            # It has more parts than an argument may have. Its words are still there.
            word = tree.word(head)
            return TypedArgument(**plain._asdict(), head=word.form, lemma=word.lemma.lower(), head_position=head)

    def _plain(self, head: int, extent: _Extent, form: ArgumentForm = ArgumentForm.PHRASE, name: str = "") -> _Plain:
        text = self._tree.text_of(extent.bare) if form is ArgumentForm.PHRASE else self._tree.word(head).form
        begins = self._tree.word(min(extent.bare, default=head) if form is ArgumentForm.PHRASE else head)
        if begins.upos == "ADV" and begins.form.istitle():
            text = text[:1].lower() + text[1:]  # "*Carefully* bring me the cup" has a capital for the sentence.
        return _Plain(name, text, self._tree.text_of(extent.positions), extent.positions)

    def _described(
        self,
        plain: _Plain,
        head: int,
        extent: _Extent,
        left_out: FrozenSet[int],
        attached: FrozenSet[int] = frozenset(),
        form: ArgumentForm = ArgumentForm.PHRASE,
    ) -> TypedArgument:
        """Return an argument with what the words around its head say; too many parts raise ValueError."""
        tree = self._tree
        own = frozenset(extent.positions)
        relation, noun = _relation(tree, head, extent)
        chosen = chosen_from(tree, noun, own)
        amount, noun = chosen if chosen is not None else (None, noun)
        children = [child for child in tree.children(noun) if child.index in own]
        word = tree.word(noun)
        amount = amount or quantity(tree, noun, children)
        conjuncts = [child for child in children if child.deprel == "conj" and child.upos not in VERBS]
        members = self._members(
            noun, [child.index for child in conjuncts], left_out | extent.prepositions, attached, form
        )
        possessor = next((child for child in children if child.deprel == "nmod:poss"), None)
        inner = [
            child
            for child in children
            if child.deprel in ("nmod", "nmod:of", "nmod:unmarked", "obl", "acl", "acl:relcl")
        ]
        inner += [tree.word(index) for index in _attached_heads(tree, attached, own)]
        by_relation = [(child, tree.preposition(child.index)) for child in inner if child.index != noun]
        complement = next(
            (child for child, prep in by_relation if prep == "of" and child.deprel.startswith("nmod")), None
        )
        exceptions = [child for child, prep in by_relation if prep in shipped_meanings().exceptions]
        argument = TypedArgument(
            **plain._asdict(),
            head=word.form,
            lemma=word.lemma.lower(),
            head_position=noun,
            is_plural=is_plural(word),
            semantic_type=self._semantic_type(noun),
            relation=relation,
            quantifier=amount.quantifier,
            count=amount.count,
            count_bound=amount.bound,
            is_negated=any(child.said in _NEGATIONS and child.deprel not in ("det", "case") for child in children),
            is_asked=amount.quantifier in ("how_many", "how_much", "which", "what"),
            direction=_direction(tree, noun, extent),
            modifiers=modifiers(tree, noun, children, own),
            possessor=None if possessor is None else self._part(possessor.index, left_out),
            complement=None if complement is None else self._part(complement.index, left_out),
            members=members,
            conjunction=_conjunction(tree, conjuncts) if members else "",
            frames=_said(tree, noun, extent)
            + tuple(
                frame
                for child, prep in by_relation
                if child is not complement and child not in exceptions
                for frame in [self._description(child, prep, left_out, own)]
                if frame is not None
            ),
        )
        left = tuple(self._part(child.index, left_out) for child in exceptions)
        return replace(
            argument,
            exceptions=tuple(of_same_kind(one, argument) if one.head.lower() in ONES else one for one in left),
        )

    def _part(self, head: int, left_out: FrozenSet[int]) -> TypedArgument:
        tree = self._tree
        extent = _extent(tree, head, left_out, frozenset())
        text = tree.text_of(index for index in extent.bare if tree.word(index).said not in _CLITICS)
        return self._described(self._plain(head, extent)._replace(text=text), head, extent, left_out)

    def _members(
        self,
        head: int,
        conjuncts: List[int],
        left_out: FrozenSet[int],
        attached: FrozenSet[int],
        form: ArgumentForm,
    ) -> Tuple[TypedArgument, ...]:
        """Return the members of a list; nothing for a phrase that is none."""
        if not conjuncts:
            return ()
        tree = self._tree
        later = frozenset(index for conjunct in conjuncts for index in tree.subtree(conjunct))
        groups = [tree.subtree(head) - later - left_out] + [tree.subtree(conjunct) - left_out for conjunct in conjuncts]
        groups[-1] |= {index for index in attached if index > head}  # "Go *over* to the hall and the office."
        found = []
        for member, group in zip([head] + conjuncts, groups):
            words = [index for index in sorted(group) if not _is_of_the_list(tree, index, head)]
            prepositions = _prepositions(tree, member)
            extent = _Extent(tuple(words), prepositions & frozenset(words))
            if not extent.bare:
                continue
            plain = self._plain(member, extent, form)
            made = self._described(plain, member, extent, left_out | later if member == head else left_out)
            found.append(self._with_noun_of(head, made) if shares_noun(tree, member, head) else made)
        found = [_of_kind_of(found[0], one) for one in found]
        return tuple(sorted(found, key=lambda one: one.positions)) if len(found) > 1 else ()

    def _with_noun_of(self, head: int, member: TypedArgument) -> TypedArgument:
        tree, noun = self._tree, self._tree.word(head)
        described = replace(tree.word(member.head_position), deprel="amod")
        return replace(
            member,
            text=f"{member.text} {noun.form}",
            head=noun.form,
            lemma=noun.lemma.lower(),
            semantic_type=self._semantic_type(head),
            modifiers=modifiers(tree, head, [described], frozenset(member.positions)) + member.modifiers,
        )

    def _description(
        self, child: Word, preposition: str, left_out: FrozenSet[int], own: FrozenSet[int]
    ) -> Optional[EmbeddedFrame]:
        """Return a phrase or a clause that describes the head as a frame; None for other words."""
        tree = self._tree
        positions = tuple(sorted((tree.subtree(child.index) & own) - left_out))
        if not positions:
            return None
        is_clause = child.deprel.startswith("acl")
        located = located_there(tree, child) if is_clause else 0
        if located:
            return EmbeddedFrame(
                role="describes",
                frame_name=_BEING_LOCATED,
                words=tree.text_of(positions),
                positions=positions,
                head_element=_LOCATION,
                mood="statement",
                frame_elements=(replace(self._part(located, left_out), name=_THEME),),
            )
        if is_clause and not preposition:
            inside = [tree.word(index) for index in positions]
            place = self._place_of_a_posture(child, own, left_out)
            return EmbeddedFrame(
                role="describes",
                frame_name=_BEING_LOCATED if place else "",
                words=tree.text_of(positions),
                positions=positions,
                head_element=_THEME if place else "",
                mood="statement",
                is_negated=any(word.said in _NEGATIONS for word in inside),
                frame_elements=place,
            )
        if not preposition:
            return None
        # "That is on the table" says the same as "on the table".
        part = self._part(child.index, left_out | _beside_a_place(tree, child.index))
        is_place = preposition in _PLACE_PREPOSITIONS
        return EmbeddedFrame(
            role="describes",
            frame_name=_BEING_LOCATED if is_place else "",
            words=tree.text_of(positions),
            positions=positions,
            head_element=_THEME if is_place else "",
            mood="statement",
            is_negated=any(word.said in _NEGATIONS for word in tree.children(child.index)),
            frame_elements=(replace(part, name=_LOCATION if is_place else part.relation or preposition),),
        )

    def _place_of_a_posture(
        self, verb: Word, own: FrozenSet[int], left_out: FrozenSet[int]
    ) -> Tuple[TypedArgument, ...]:
        """Return where somebody is who is said to stand, sit or lie there: "a person sitting in the hall"."""
        tree = self._tree
        if verb.lemma.lower() not in _POSTURES:
            return ()
        return tuple(
            replace(self._part(child.index, left_out), name=_LOCATION)
            for child in tree.children(verb.index)
            if child.deprel.startswith("obl")
            and child.index in own
            and tree.preposition(child.index) in _PLACE_PREPOSITIONS
        )[:1]


def _is_of_the_list(tree: DependencyTree, index: int, head: int) -> bool:
    """Whether a word belongs to no member of a list: a comma, "and", "*both* the cup and the plate", "*then* the
    plate", "*also* the plate".
    """
    word = tree.word(index)
    is_order = word.upos == "ADV" and word.said in _ORDER
    # "Both mugs and the plate": there are two mugs.
    is_before = index < head and word.said in _BEFORE_LISTS and not is_plural(tree.word(head))
    return word.upos == "PUNCT" or word.deprel == "cc" or is_before or is_order


def _attached_heads(tree: DependencyTree, attached: FrozenSet[int], own: FrozenSet[int]) -> List[int]:
    """Return the heads of phrases that belong to the noun although the tree attaches them to the verb."""
    return [
        index
        for index in sorted(attached & own)
        if tree.word(index).head not in own and tree.word(index).upos in NOMINALS
    ]


def _of_kind_of(first: TypedArgument, member: TypedArgument) -> TypedArgument:
    """Return a member of a list with the noun of the first: "the red cup and *the blue one*". "That one" is shown."""
    is_one = member.head.lower() in ONES and first.head.lower() not in ONES
    return of_same_kind(member, first) if is_one and member.quantifier not in _DEMONSTRATIVES else member


def _said(tree: DependencyTree, head: int, extent: _Extent) -> Tuple[EmbeddedFrame, ...]:
    """Return the clause that a message says: "where the keys are"; nothing for other phrases."""
    if head not in tree.quoted or len(extent.bare) < 2:
        return ()
    is_question = tree.word(extent.bare[0]).said in _QUESTION_WORDS
    words = tree.text_of(extent.bare)
    mood = "question" if is_question else "statement"
    return (EmbeddedFrame(role="says", words=words, positions=tuple(extent.bare), mood=mood),)


def _extent(tree: DependencyTree, head: int, left_out: FrozenSet[int], attached: FrozenSet[int]) -> _Extent:
    """Return the words of a phrase, without punctuation and conjunctions at its ends."""
    positions = sorted((tree.subtree(head) - left_out) | attached)
    # In "whether it is on the table" the preposition is part of the question, in "to where you were" it is not.
    is_clause = tree.word(head).said not in _QUESTION_WORDS and any(
        child.deprel == "cop" and child.index in positions for child in tree.children(head)
    )
    prepositions = frozenset() if is_clause else _prepositions(tree, head)
    while len(positions) > 1 and tree.word(positions[-1]).upos == "PUNCT" and not _ends_quotation(tree, positions):
        positions.pop()
    while (
        len(positions) > 1
        and positions[0] not in prepositions
        and (tree.word(positions[0]).upos == "PUNCT" or tree.word(positions[0]).deprel in _BEFORE_A_PHRASE)
    ):
        positions.pop(0)
    if prepositions and positions and positions[0] < min(prepositions):
        prepositions |= frozenset(index for index in attached if index < min(prepositions))
    return _Extent(tuple(positions), prepositions)


def _ends_quotation(tree: DependencyTree, positions: Sequence[int]) -> bool:
    """Whether a phrase ends with a mark of a quotation that begins inside: 'the book "Gone with the wind"'."""
    marks = [index for index in positions if tree.word(index).form in QUOTATION_MARKS]
    return len(marks) % 2 == 0 and marks[-1:] == list(positions[-1:]) and marks[:1] != list(positions[:1])


def _said_around(tree: DependencyTree, head: int) -> FrozenSet[int]:
    """Return words that the parser attaches to a phrase that is a predicate, such as "robot" in "*robot*, the mug is on
    the table, *please*"."""
    around = [child.index for child in tree.children(head) if child.deprel in ("vocative", "discourse")]
    return frozenset().union(*map(tree.subtree, around))


def _prepositions(tree: DependencyTree, head: int) -> FrozenSet[int]:
    found: List[int] = []
    for child in tree.children(head):
        # In "by crossing the hall" the preposition of the verb has the relation "mark".
        is_preposition = child.deprel == "case" or (child.deprel == "mark" and child.said in _OF_VERBS)
        if is_preposition and child.index < head:
            found += tree.subtree(child.index)
    return frozenset(found)


def _beside_a_place(tree: DependencyTree, head: int) -> FrozenSet[int]:
    """Return the words of a relative clause that only say that something is somewhere: "that is"."""
    return frozenset(
        child.index
        for child in tree.children(head)
        if child.deprel == "cop" or (child.deprel.startswith("nsubj") and child.said in _RELATIVE_WORDS)
    )


def _relation(tree: DependencyTree, head: int, extent: _Extent) -> Tuple[str, int]:
    """Return the relation of a phrase to the action, and the noun that it relates to.

    In "to the left of the table" and "on top of the table" this noun is the table, though another word is the head.
    """
    spoken = [tree.word(index).said for index in sorted(extent.prepositions & frozenset(extent.positions))]
    meanings = shipped_meanings()
    form = tree.word(head).said
    inside = [child.index for child in tree.children(head) if child.deprel.startswith("nmod")]
    whole = next((index for index in inside if index in extent.positions and tree.preposition(index) == "of"), None)
    if whole is not None and form in _LEFT_AND_RIGHT and is_side_of_something(tree, head):
        return f"{form}_of", whole
    if whole is not None and spoken and f"{' '.join(spoken)} {form} of" in _COMPLEX_PREPOSITIONS:
        return meanings.relation(f"{' '.join(spoken)} {form} of"), whole
    governor = tree.word(head).head
    if spoken == ["of"] and governor:
        # A lexical unit may ask for the inner noun itself.
        before = sorted(_prepositions(tree, governor)) + [governor]
        words = " ".join(tree.word(index).said for index in before) + " of"
        if words in _COMPLEX_PREPOSITIONS:
            return meanings.relation(words), head
    return (meanings.relation(" ".join(spoken)) if spoken else ""), head


def _conjunction(tree: DependencyTree, conjuncts: Iterable[Word]) -> str:
    coordinators = (
        inner.said for conjunct in conjuncts for inner in tree.children(conjunct.index) if inner.deprel == "cc"
    )
    said = next(coordinators, "and")
    # "Not only the cup but also the plate", "the cup as well as the plate".
    return "and" if said in _ADDING else said


def _direction(tree: DependencyTree, head: int, extent: _Extent) -> str:
    """Return the direction that a phrase names: "left" in "to your left"; none for a thing."""
    directions = shipped_meanings().directions
    spoken = " ".join(tree.word(index).said for index in extent.bare)
    if spoken in directions:
        return directions[spoken]
    form = tree.word(head).said
    is_side = form in _LEFT_AND_RIGHT and not is_side_of_something(tree, head) and not extent.bare[-1] > head
    return directions.get(form, "") if is_side else ""
