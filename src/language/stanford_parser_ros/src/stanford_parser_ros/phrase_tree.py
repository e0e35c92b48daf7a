"""The phrase tree of a sentence, with Penn Treebank tags: from the constituency parser, or projected from dependencies.

A head projects a phrase. Its dependents are the other children of the phrase, in the order of the sentence. A word with
a preposition becomes a PP of the preposition and the rest.
"""

from dataclasses import dataclass
from typing import Any, Dict, List, Tuple

from utterance_passes.trees.tree import DependencyTree, Word

_PHRASE_OF_UPOS: Dict[str, str] = {
    "NOUN": "NP",
    "PROPN": "NP",
    "PRON": "NP",
    "NUM": "NP",
    "VERB": "VP",
    "AUX": "VP",
    "ADJ": "ADJP",
    "ADV": "ADVP",
    "INTJ": "INTJ",
    "SYM": "NP",
    "X": "X",
}


class Tree:
    """A node of a phrase tree, as in 2012.

    Attributes:
        tag: Penn Treebank tag, such as ``NP`` or ``-TMP``
        score: confidence of the parser, 0 to 1
        word: the word of a leaf, empty for a phrase
        word_index: position of the word in ``Parse.words``, -1 for a phrase
        children: in the order of the sentence
    """

    def __init__(self, tag: str, score: float, word: str = "", word_index: int = -1) -> None:
        self.tag = tag
        self.score = score
        self.word = word
        self.word_index = word_index
        self.children: List[Tree] = []

    def __repr__(self) -> str:
        inside = self.word or " ".join(repr(child) for child in self.children)
        return f"({self.tag} {inside})"


@dataclass(frozen=True)
class SquashedNode:
    """A node of a flattened tree: the fields of ``stanford_parser_msgs/SquashedParseTreeNode``, with a Penn tag."""

    tag: str
    parent_id: int
    score: float
    word_index: int


def phrase_tree(tree: DependencyTree) -> Tree:
    """Return the phrase tree of a sentence: that of the constituency parser, or else the one that its heads project."""
    if tree.brackets:
        return from_brackets(tree.brackets)
    root = Tree("ROOT", 1.0)
    clause = Tree("S", 1.0)
    root.children.append(clause)
    for word in tree.children(0):
        clause.children.append(_project(tree, word))
    return root


def from_brackets(text: str) -> Tree:
    """Read a phrase tree in brackets: "(ROOT (NP (DT the) (NN cup)))". Words are counted from 1.

    Raises:
        ValueError: the brackets do not match
    """
    open_nodes: List[Tree] = []
    position = 0
    tokens = text.replace("(", " ( ").replace(")", " ) ").split()
    for number, token in enumerate(tokens):
        if token == "(":
            if number + 1 == len(tokens) or tokens[number + 1] in "()":
                raise ValueError(f"a bracket without a tag: {text!r}")
            open_nodes.append(Tree(tokens[number + 1], 1.0))
        elif token == ")":
            if not open_nodes:
                raise ValueError(f"a bracket that closes nothing: {text!r}")
            node = open_nodes.pop()
            if not open_nodes:
                if number + 1 != len(tokens):
                    raise ValueError(f"more than one tree: {text!r}")
                return node
            open_nodes[-1].children.append(node)
        elif tokens[number - 1] != "(" and open_nodes:
            position += 1
            open_nodes[-1].word, open_nodes[-1].word_index = token, position
    raise ValueError(f"a bracket that is not closed: {text!r}")


def _project(tree: DependencyTree, word: Word) -> Tree:
    leaf = Tree(word.xpos or "X", 1.0, word.form, word.index)
    children = tree.children(word.index)
    cases = [child for child in children if child.deprel == "case" and child.xpos != "POS"]
    rest = [child for child in children if child not in cases]
    if not rest and word.upos not in _PHRASE_OF_UPOS:
        core = leaf
    else:
        core = Tree(_PHRASE_OF_UPOS.get(word.upos, "X"), 1.0)
        before = [child for child in rest if child.index < word.index]
        after = [child for child in rest if child.index > word.index]
        core.children = (
            [_project(tree, child) for child in before] + [leaf] + [_project(tree, child) for child in after]
        )
    if not cases:
        return core
    phrase = Tree("PP", 1.0)
    phrase.children = sorted([_project(tree, case) for case in cases] + [core], key=first_index)
    return phrase


def first_index(tree: Tree) -> int:
    """Return the position of the first word below a node."""
    return tree.word_index if tree.word else min(first_index(child) for child in tree.children)


def squash(tree: Tree) -> Tuple[SquashedNode, ...]:
    """Flatten a tree; a parent precedes its children."""
    nodes: List[SquashedNode] = []

    def visit(node: Tree, parent_id: int) -> None:
        own = len(nodes)
        nodes.append(SquashedNode(node.tag, parent_id, node.score, node.word_index))
        for child in node.children:
            visit(child, own)

    visit(tree, -1)
    return tuple(nodes)


def constant_of_tag(tag: str) -> str:
    """Return the name of the message constant of a Penn tag: ``-TMP`` is ``_TMP``, ``PRP$`` is ``PRP_S``, an unknown
    one ``X``.
    """
    name = tag.replace("-", "_").replace("$", "_S")
    return name if name.replace("_", "").isalpha() and name.isascii() else "SYM"


def unsquash(nodes: Tuple[SquashedNode, ...], words: Tuple[str, ...]) -> Tree:
    """Rebuild a tree.

    Raises:
        ValueError: there is no node or no root, or a parent is not an earlier node
    """
    built: List[Tree] = []
    for position, node in enumerate(nodes):
        word = words[node.word_index] if 0 <= node.word_index < len(words) else ""
        tree = Tree(node.tag, node.score, word, node.word_index)
        if position and not 0 <= node.parent_id < position:
            raise ValueError(f"node {position}: its parent must precede it, found {node.parent_id}")
        if position:
            built[node.parent_id].children.append(tree)
        built.append(tree)
    if not built or nodes[0].parent_id != -1:
        raise ValueError("a squashed tree begins with its root, whose parent is -1")
    return built[0]


def unsquash_tree(squashed_tree: Any) -> Tree:
    """Return the phrase tree of a ``stanford_parser_msgs/Parse`` message, as in 2012.

    Raises:
        ValueError: the message holds no tree
    """
    names = _names_of_constants(squashed_tree)
    nodes = tuple(
        SquashedNode(names.get(node.tag, "X"), node.parent_id, node.score, node.word_index)
        for node in squashed_tree.nodes
    )
    return unsquash(nodes, tuple(squashed_tree.words))


def _names_of_constants(parse: Any) -> Dict[int, str]:
    if not parse.nodes:
        return {}
    constants = {
        name: value for name, value in vars(type(parse.nodes[0])).items() if name.isupper() and isinstance(value, int)
    }
    return {
        value: name.replace("_S", "$") if name in ("PRP_S", "WP_S") else name.replace("_", "-")
        for name, value in constants.items()
    }
