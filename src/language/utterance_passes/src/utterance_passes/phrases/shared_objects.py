"""Finds the object that joined verbs share."""

from utterance_passes.phrases.clauses import is_then
from utterance_passes.trees.tree import DependencyTree, Word


def shared_object(tree: DependencyTree, verb: int) -> int:
    """Return the object behind the verb that is joined right behind this one, which has nothing behind it itself: "open
    and close *the door*"; 0 if none.

    Behind such an object, "twice" or "slowly" would be said of both deeds.
    """
    end = max([verb, *(child.index for child in tree.children(verb) if child.deprel == "compound:prt")])
    behind = (word for word in tree.words[end:] if word.deprel not in ("cc", "punct") and not is_then(word))
    following = next(behind, None)
    if following is None or (following.deprel, following.upos) != ("conj", "VERB"):
        return 0
    if following.head not in (verb, tree.word(verb).head):
        return 0
    children = [child for child in tree.children(following.index) if child.index > following.index]
    shared = next((child.index for child in children if child.deprel == "obj"), 0)
    if any(child.index > shared and _is_of_all_deeds(tree, child) for child in children):
        return 0
    return shared or shared_object(tree, following.index)


def _is_of_all_deeds(tree: DependencyTree, word: Word) -> bool:
    is_amount = word.deprel == "obl" and any(child.deprel == "nummod" for child in tree.children(word.index))
    return is_amount or word.deprel in ("advmod", "obl:unmarked", "obl:tmod", "nmod:unmarked")
