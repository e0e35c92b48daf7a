"""Converts Universal Dependencies (v2) to the typed dependencies of the Stanford Dependencies manual.

Sources: M.-C. de Marneffe and C. Manning, *Stanford typed dependencies manual* (2008, revised 2013) for the names and
for collapsing; universaldependencies.org/u/dep and /en/dep for the universal relations.
"""

from dataclasses import dataclass
from typing import Dict, FrozenSet, List, Optional, Set, Tuple

from utterance_passes.trees.tree import VERBS, DependencyTree, Word
from word_classes import word_class, word_list

#: Universal relation -> Stanford names. The first name is written into ``Parse``; a lexical unit may use any. Measures
#: ("3 feet" in "move forward 3 feet") were tmod, npadvmod or dobj, depending on the words: all are accepted.
RULES: Dict[str, Tuple[str, ...]] = {
    "root": ("root",),
    "nsubj": ("nsubj",),
    "nsubj:pass": ("nsubjpass",),
    "nsubj:outer": ("nsubj",),
    "csubj": ("csubj",),
    "csubj:pass": ("csubjpass",),
    "csubj:outer": ("csubj",),
    "obj": ("dobj",),
    "iobj": ("iobj",),
    "ccomp": ("ccomp",),
    "xcomp": ("xcomp", "acomp"),
    "advcl": ("advcl", "purpcl"),
    "advcl:relcl": ("advcl",),
    "advmod": ("advmod",),
    "amod": ("amod",),
    "det": ("det",),
    "det:predet": ("predet",),
    "nummod": ("num", "number"),
    "appos": ("appos", "abbrev"),
    "compound": ("nn",),
    "compound:prt": ("prt", "advmod"),
    "flat": ("nn",),
    "nmod:desc": ("nn",),
    "nmod:poss": ("poss",),
    "fixed": ("mwe",),
    "goeswith": ("goeswith",),
    "list": ("dep",),
    "dep": ("dep",),
    "obl:unmarked": ("tmod", "npadvmod", "dobj"),
    "obl:tmod": ("tmod", "npadvmod", "dobj"),
    "obl:npmod": ("npadvmod", "tmod", "dobj"),
    "nmod:unmarked": ("npadvmod", "tmod"),
    "nmod:tmod": ("tmod", "npadvmod"),
    "nmod:npmod": ("npadvmod",),
    "obl:agent": ("agent",),
    "acl": ("vmod", "partmod", "infmod"),
    "acl:relcl": ("rcmod",),
    "aux": ("aux",),
    "aux:pass": ("auxpass",),
    "cop": ("cop",),
    "mark": ("mark", "complm"),
    "case": ("prep",),
    "cc": ("cc",),
    "cc:preconj": ("preconj",),
    "conj": ("conj",),
    "parataxis": ("parataxis",),
    "discourse": ("discourse",),
    "vocative": ("vocative",),
    "expl": ("expl",),
    "dislocated": ("dep",),
    "orphan": ("dep",),
    "reparandum": ("dep",),
    "punct": ("punct",),
    "clf": ("dep",),
}
#: Nouns that make a prepositional phrase one preposition: "in front of the fridge" -> prep_in_front_of(go, fridge).
_COMPLEX_PREPOSITIONS: Dict[Tuple[str, ...], str] = {
    tuple(phrase.split()[:2]): phrase.replace(" ", "_") for phrase in word_list("complex_prepositions")
}
_NEGATING_ADVERBS = word_class("negating_adverbs")


@dataclass(frozen=True)
class Arc:
    """A relation between two words, with all of its names.

    Attributes:
        governor: index of the governing word, 0 for the root
        dependent: index of the dependent word
        relations: Universal names ("obl", "obl:to") and Stanford names, basic and collapsed ("prep_to")
    """

    governor: int
    dependent: int
    relations: FrozenSet[str]


@dataclass(frozen=True)
class TypedDependency:
    """A Stanford typed dependency.

    Attributes:
        relation: its name
        governor: index of the governing word, 0 for the root
        dependent: index of the dependent word
    """

    relation: str
    governor: int
    dependent: int


def preposition(tree: DependencyTree, word: Word) -> str:
    """Return the preposition of a word as in collapsed names: "to", "next_to", "out_of"; empty for none."""
    parts: List[str] = []
    for child in tree.children(word.index):
        if child.deprel == "case" and child.said not in ("'s", "'", "’s"):
            parts.append(child.said)
            parts += [inner.said for inner in tree.children(child.index) if inner.deprel == "fixed"]
    return "_".join(part for part in parts if part.replace("-", "").isalpha())


def stanford_names(tree: DependencyTree, word: Word) -> Tuple[str, ...]:
    """Return the Stanford names of the relation of a word to its head; ``Parse`` gets the first."""
    lemma = word.lemma.lower()
    if word.deprel == "advmod" and (lemma in _NEGATING_ADVERBS or word.said in _NEGATING_ADVERBS):
        return ("neg", "advmod")
    if word.deprel == "mark" and word.said == "to":
        return ("aux", "mark")
    if word.deprel == "mark" and lemma in ("that", "whether"):
        return ("complm", "mark")
    if word.deprel == "case" and word.said in ("'s", "'", "’s"):
        return ("possessive",)
    if word.deprel == "conj":
        return (f"conj_{_coordinator(tree, word)}", "conj")
    base = word.deprel.split(":")[0]
    prep = preposition(tree, word)
    if prep and base in ("obl", "nmod", "advmod", "xcomp", "ccomp", "obj", "acl", "advcl"):
        agent = ("agent",) if word.deprel == "obl:agent" else ()
        return agent + (f"prep_{prep}", "prep")
    if base == "advcl":
        mark = next((child.said for child in tree.children(word.index) if child.deprel == "mark"), "")
        if mark and mark != "to":
            return RULES["advcl"] + (f"prepc_{mark}",)
    if word.deprel in RULES:
        return RULES[word.deprel]
    return RULES.get(base, ("dep",))


def arcs(tree: DependencyTree) -> Tuple[Arc, ...]:
    """Return every relation of a sentence with all of its names, collapsed and propagated to conjuncts.

    In addition to the arcs of the tree, "in front of the fridge" relates *go* and *fridge* directly, "the mug and the
    plate" relates both to the verb, and in "the cup is on the table" both *cup* and *table* depend on *is*, as in the
    Stanford scheme.
    """
    found: List[Arc] = []
    for word in tree.words:
        names = _all_names(tree, word)
        found.append(Arc(word.head, word.index, names))
        inner = _complex_preposition(tree, word)
        if inner is not None:
            found.append(Arc(word.head, inner[0], inner[1]))
        copula = next((child for child in tree.children(word.index) if child.deprel == "cop"), None)
        if copula is not None:
            found += _arcs_of_copula(tree, word, copula)
    return tuple(found + _propagated(tree, found))


def _all_names(tree: DependencyTree, word: Word) -> FrozenSet[str]:
    base = word.deprel.split(":")[0]
    names: Set[str] = {word.deprel, base}
    names.update(stanford_names(tree, word))
    prep = preposition(tree, word)
    if prep:
        names.add(f"{base}:{prep}")
        # "From behind the sink" counts as "from the sink".
        if prep.startswith("from_"):
            names |= {f"{base}:from", "prep_from"}
    return frozenset(names)


def _complex_preposition(tree: DependencyTree, word: Word) -> Optional[Tuple[int, FrozenSet[str]]]:
    joined = _COMPLEX_PREPOSITIONS.get((preposition(tree, word), word.lemma.lower()))
    if joined is None:
        return None
    inner = next((child for child in tree.children(word.index) if preposition(tree, child) == "of"), None)
    if inner is None:
        return None
    base = word.deprel.split(":")[0]
    return inner.index, frozenset({base, f"{base}:{joined}", f"prep_{joined}", "prep"})


def _arcs_of_copula(tree: DependencyTree, predicate: Word, copula: Word) -> List[Arc]:
    """Predicates for which the Stanford scheme makes the form of "be" the head: prepositional phrases and "where"."""
    found = []
    for child in tree.children(predicate.index):
        if child.deprel.startswith(("nsubj", "expl")):
            found.append(Arc(copula.index, child.index, _all_names(tree, child)))
    prep = preposition(tree, predicate)
    names = {f"prep_{prep}", "prep", f"obl:{prep}", "obl"} if prep else {"attr", "acomp"}
    found.append(Arc(copula.index, predicate.index, frozenset(names)))
    return found


def _propagated(tree: DependencyTree, found: List[Arc]) -> List[Arc]:
    """Relations that a conjunct shares with the first conjunct: its role, and the subject of a conjoined verb."""
    extra: List[Arc] = []
    for word in tree.words:
        if word.deprel != "conj" or word.head == 0:
            continue
        first = tree.governor(word)
        is_verbal = word.upos in VERBS
        own = {name for child in tree.children(word.index) for name in [child.deprel.split(":")[0]]}
        if is_verbal:
            extra += [
                Arc(word.index, child.index, _all_names(tree, child))
                for child in tree.children(first.index)
                if child.deprel.startswith("nsubj") and "nsubj" not in own
            ]
        elif not preposition(tree, word):
            extra += [
                Arc(arc.governor, word.index, arc.relations)
                for arc in found
                if arc.dependent == first.index and arc.governor != 0 and "conj" not in arc.relations
            ]
        elif first.head != 0:
            prep = preposition(tree, word)
            extra.append(Arc(first.head, word.index, frozenset({"obl", f"obl:{prep}", f"prep_{prep}", "prep"})))
    return extra


def _coordinator(tree: DependencyTree, word: Word) -> str:
    own = [child.said for child in tree.children(word.index) if child.deprel == "cc"]
    if own:
        return own[0]
    siblings = [
        other for other in tree.words if other.head == word.head and other.deprel == "conj" and other.index > word.index
    ]
    later = [child.said for sibling in siblings for child in tree.children(sibling.index) if child.deprel == "cc"]
    return later[0] if later else "and"


def basic(tree: DependencyTree) -> Tuple[TypedDependency, ...]:
    """Return the basic typed dependencies: every word has one governor, and prepositions are words of their own (prep
    and pobj)."""
    found = []
    for word in tree.words:
        names = stanford_names(tree, word)
        cases = [child for child in tree.prepositions(word.index) if names[0].startswith(("prep_", "agent"))]
        if cases:
            found.append(TypedDependency("prep", word.head, cases[0].index))
            found.append(TypedDependency("pobj", cases[0].index, word.index))
        elif word.deprel == "case" and stanford_names(tree, tree.governor(word))[0].startswith(("prep_", "agent")):
            first = tree.prepositions(word.head)[0]
            if first.index != word.index:
                found.append(TypedDependency("mwe", first.index, word.index))
        else:
            found.append(TypedDependency("conj" if word.deprel == "conj" else names[0], word.head, word.index))
    return tuple(sorted(found, key=lambda dependency: dependency.dependent))


def collapsed(tree: DependencyTree) -> Tuple[TypedDependency, ...]:
    """Return the collapsed typed dependencies: prepositions and coordinators are part of the relation's name."""
    found: Dict[Tuple[int, int], str] = {}
    for word in tree.words:
        names = stanford_names(tree, word)
        if word.deprel in ("case", "cc") and names[0] != "possessive":
            continue
        if word.deprel == "fixed" and tree.governor(word).deprel == "case":
            continue
        found[(word.head, word.index)] = names[0]
    for arc in arcs(tree):
        name = next((name for name in sorted(arc.relations) if name.startswith("prep_")), None) or next(
            (name for name in sorted(arc.relations) if name in ("dobj", "iobj", "nsubj")), None
        )
        if name is not None and (arc.governor, arc.dependent) not in found and arc.governor != 0:
            found[(arc.governor, arc.dependent)] = name
    return tuple(
        TypedDependency(name, governor, dependent)
        for (governor, dependent), name in sorted(found.items(), key=lambda item: (item[0][1], item[0][0]))
    )
