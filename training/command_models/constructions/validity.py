"""What a generated tree must be beyond a tree: the rules of Universal Dependencies that its relations obey."""

from typing import Dict, FrozenSet, List

from command_models.conllu import Sentence, problems
from command_models.conventions import TELLING

_NOMINAL = frozenset("NOUN PROPN PRON NUM SYM X DET ADJ ADV VERB INTJ ADP".split())
#: Parts of speech that a relation allows.
_UPOS: Dict[str, FrozenSet[str]] = {
    "aux": frozenset(("AUX",)),
    "aux:pass": frozenset(("AUX",)),
    "cop": frozenset(("AUX",)),
    "case": frozenset(("ADP", "PART", "ADV", "SCONJ")),
    "mark": frozenset(("SCONJ", "PART", "ADP", "ADV")),
    "cc": frozenset(("CCONJ", "ADV")),
    "cc:preconj": frozenset(("CCONJ", "DET")),
    "det": frozenset(("DET",)),
    "det:predet": frozenset(("DET",)),
    "nummod": frozenset(("NUM",)),
    "punct": frozenset(("PUNCT",)),
    "compound:prt": frozenset(("ADP",)),
    "expl": frozenset(("PRON",)),
    "advmod": frozenset(("ADV", "PART", "ADJ", "NUM")),
    "amod": frozenset(("ADJ", "VERB", "NUM")),
    "nmod:poss": frozenset(("NOUN", "PROPN", "PRON")),
    "discourse": frozenset(("INTJ", "NOUN", "ADV", "PART", "PROPN")),
    "vocative": frozenset(("NOUN", "PROPN")),
    "flat": frozenset(("NOUN", "PROPN", "NUM")),
}
#: Relations whose words have no dependants, but for these.
_LEAVES: Dict[str, FrozenSet[str]] = {
    "aux": frozenset(("punct",)),
    "aux:pass": frozenset(("punct",)),
    "cop": frozenset(("punct",)),
    "case": frozenset(("fixed", "advmod", "punct", "conj")),
    "mark": frozenset(("fixed", "advmod", "punct")),
    "cc": frozenset(("fixed", "punct")),
    "det": frozenset(("advmod", "fixed", "punct")),
    "punct": frozenset(),
    "fixed": frozenset(),
    "expl": frozenset(),
    "compound:prt": frozenset(("advmod",)),
}
_ONCE = frozenset(("nsubj", "nsubj:pass", "obj", "iobj", "cop", "expl"))


def violations(sentence: Sentence, *, projective: bool = True) -> List[str]:
    """Return what is wrong with a tree: no tree, crossing arcs, a relation with a part of speech that it never has.

    Args:
        sentence: the tree
        projective: whether no arcs may cross
    """
    found = problems(sentence)
    if found:
        return found
    words = sentence.words
    seen: Dict[int, List[str]] = {}
    for place, word in enumerate(words, 1):
        allowed = _UPOS.get(word.deprel)
        if allowed is not None and word.upos not in allowed:
            found.append(f"word {place} ({word.form}): {word.deprel} is {word.upos}")
        governor = words[word.head - 1].deprel if word.head else ""
        leaf = _LEAVES.get(governor)
        if leaf is not None and word.deprel not in leaf:
            found.append(f"word {place} ({word.form}): {word.deprel} hangs on a word that is {governor}")
        if word.upos == "PUNCT" and word.deprel != "punct":
            found.append(f"word {place} ({word.form}): punctuation is {word.deprel}")
        if word.upos == "AUX" and word.deprel not in (
            "aux",
            "aux:pass",
            "cop",
            "root",
            "conj",
            "reparandum",
            "parataxis",
            "advcl",
        ):
            found.append(f"word {place} ({word.form}): an auxiliary is {word.deprel}")
        if word.deprel in _ONCE:
            if word.deprel in seen.setdefault(word.head, []):
                found.append(f"word {word.head}: two dependants are {word.deprel}")
            seen[word.head].append(word.deprel)
        if word.deprel in ("conj", "fixed", "flat", "appos") and word.head > place:
            found.append(f"word {place} ({word.form}): {word.deprel} stands before its governor")
    for head, relations in seen.items():
        told = head > 0 and words[head - 1].lemma in TELLING
        if "obj" not in relations and "ccomp" not in relations and "iobj" in relations and not told:
            # "tell me whether ...", "ask Anna when ..." have a clause in the place of the object.
            if not any(word.head == head and word.deprel in ("ccomp", "xcomp") for word in words):
                found.append(f"word {head}: an indirect object without an object")
    if projective and (crossing := _crossing(sentence)):
        found.append(crossing)
    return found


def _crossing(sentence: Sentence) -> str:
    arcs = [(min(place, word.head), max(place, word.head)) for place, word in enumerate(sentence.words, 1) if word.head]
    for left, right in arcs:
        for other_left, other_right in arcs:
            if left < other_left < right < other_right:
                return f"arcs {left}-{right} and {other_left}-{other_right} cross"
    return ""
