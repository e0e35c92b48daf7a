"""Converts parses to messages and back."""

from typing import List, Sequence

from roboframenet_msgs.msg import Command, CommandParse
from stanford_parser_msgs.msg import Alternative as AlternativeMessage
from stanford_parser_msgs.msg import Dependency, Parse, SquashedParseTreeNode, UniversalWord

from stanford_parser_ros.phrase_tree import constant_of_tag, phrase_tree, squash
from stanford_parser_ros.stanford_dependencies import collapsed
from utterance_passes.trees.tree import Alternative, DependencyTree, Word


def to_command_parse(command: Command, tree: DependencyTree) -> CommandParse:
    """Return the parse of a command as a message."""
    return CommandParse(
        command=command,
        parse=to_parse(tree),
        words=[
            UniversalWord(
                index=word.index,
                form=word.form,
                lemma=word.lemma,
                upos=word.upos,
                xpos=word.xpos,
                feats=word.feats,
                head=word.head,
                deprel=word.deprel,
                start_character=word.start_character,
                end_character=word.end_character,
            )
            for word in tree.words
        ],
        alternatives=[
            AlternativeMessage(word=one.word, head=one.head, deprel=one.deprel, probability=one.probability)
            for one in tree.alternatives
        ],
    )


def to_parse(tree: DependencyTree) -> Parse:
    """Return the parse as in 2012: collapsed Stanford dependencies whose indices are positions in ``words``."""
    return Parse(
        nodes=[
            SquashedParseTreeNode(
                tag=getattr(SquashedParseTreeNode, constant_of_tag(node.tag), SquashedParseTreeNode.X),
                parent_id=node.parent_id,
                score=node.score,
                word_index=node.word_index,
            )
            for node in squash(phrase_tree(tree))
        ],
        dependencies=[
            Dependency(
                relation=dependency.relation, governor_index=dependency.governor, dependent_index=dependency.dependent
            )
            for dependency in collapsed(tree)
        ],
        words=["ROOT"] + [word.form for word in tree.words],
        tags=["ROOT"] + [word.xpos for word in tree.words],
    )


def to_tree(text: str, words: List[UniversalWord], alternatives: Sequence[AlternativeMessage] = ()) -> DependencyTree:
    """Return the tree of a message, with what else its words may hang on."""
    return DependencyTree(
        text=text,
        words=tuple(
            Word(
                index=word.index,
                form=word.form,
                lemma=word.lemma,
                upos=word.upos,
                xpos=word.xpos,
                feats=word.feats,
                head=word.head,
                deprel=word.deprel,
                start_character=word.start_character,
                end_character=word.end_character,
            )
            for word in words
        ),
        alternatives=tuple(Alternative(one.word, one.head, one.deprel, one.probability) for one in alternatives),
    )
