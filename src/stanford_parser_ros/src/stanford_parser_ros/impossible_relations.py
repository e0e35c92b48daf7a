"""Relations that no sentence of Universal Dependencies has, and what stands in their place.

A parser labels each arc by itself. What the arcs around it rule out is put right here, by the guidelines of UD v2.
"""

from dataclasses import replace

from stanford_parser_ros.tree import DependencyTree, Word


def mended(tree: DependencyTree) -> DependencyTree:
    """Return a tree with the same words and heads, in which impossible relations have become possible ones."""
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
    return word
