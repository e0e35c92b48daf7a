"""Relations that no sentence of Universal Dependencies has, and what stands in their place.

A parser labels each arc by itself. What the arcs around it rule out is put right here, by the guidelines of UD v2.
"""

from dataclasses import replace

from stanford_parser_ros.tree import DependencyTree, Word


def mended(tree: DependencyTree) -> DependencyTree:
    """Return a tree with the same words in which impossible relations have become possible ones."""
    tree = _with_one_object(tree)
    words = tuple(_mended(word, tree) for word in tree.words)
    return tree if words == tree.words else replace(tree, words=words)


def _mended(word: Word, tree: DependencyTree) -> Word:
    if word.head == 0:
        return word
    # A particle has no copula: "check if the lights are off" asks whether they are off.
    if word.deprel == "compound:prt" and any(child.deprel == "cop" for child in tree.children(word.index)):
        return replace(word, deprel="ccomp")
    # A verb compounds with no verb before it: "go get the mug" is to go, and to get it.
    head = tree.word(word.head)
    if word.deprel == "compound" and head.upos == word.upos == "VERB" and head.index < word.index:
        return replace(word, deprel="xcomp")
    # "To" joins no conjuncts: "turn left to face the door" says what for.
    marks = [child.deprel for child in tree.children(word.index) if child.form.lower() == "to"]
    if word.deprel == "conj" and word.upos == "VERB" and "mark" in marks and not _is_infinitive(tree, head):
        if all(child.deprel != "cc" for child in tree.children(word.index)):
            return replace(word, deprel="advcl")
    return word


def _is_infinitive(tree: DependencyTree, word: Word) -> bool:
    return any(child.deprel == "mark" and child.form.lower() == "to" for child in tree.children(word.index))


def _with_one_object(tree: DependencyTree) -> DependencyTree:
    """Return a tree in which a particle between two objects of a verb is the preposition of the second.

    A verb has one object: "pick up the cup off the foot of the bed".
    """
    for particle in tree.words:
        if particle.deprel != "compound:prt":
            continue
        objects = [child for child in tree.children(particle.head) if child.deprel == "obj"]
        first = [child for child in objects if child.index < particle.index]
        second = [child for child in objects if tree.subtree(child.index)[0].index == particle.index + 1]
        if first and second:
            words = list(tree.words)
            words[particle.index - 1] = replace(particle, upos="ADP", xpos="IN", head=second[0].index, deprel="case")
            words[second[0].index - 1] = replace(second[0], deprel="obl")
            tree = replace(tree, words=tuple(words))
    return tree
