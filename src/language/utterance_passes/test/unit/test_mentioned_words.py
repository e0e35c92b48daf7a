"""Clauses between quotation marks that are spoken of, in parses as odd as a parser makes them."""

from utterance_passes.messages.mentioned_words import mentioned_words
from utterance_passes.trees.conllu import from_conllu
from utterance_passes.trees.tree import QUOTED
from utterance_passes.trees.vocabulary import Verbs


def test_words_that_the_parser_joined_by_a_word_outside_stay_a_tree() -> None:
    # 'forget "open it"', with "open" under "forget", and "forget" under "it"
    tree = mentioned_words.run(
        from_conllu(
            '1 forget forget VERB VB _ 4 dep _ _\n2 " " PUNCT `` _ 3 punct _ _\n3 open open VERB VB _ 1 ccomp _ _\n'
            "4 it it PRON PRP _ 0 root _ _\n5 \" \" PUNCT '' _ 3 punct _ _"
        ),
        Verbs(),
    )
    assert [word.head for word in tree.words] == [4, 4, 4, 0, 4]
    assert tree.word(3).deprel == QUOTED


def test_a_mark_that_governs_its_words_keeps_its_place() -> None:
    tree = from_conllu(
        '1 forget forget VERB VB _ 0 root _ _\n2 " " PUNCT `` _ 1 punct _ _\n3 open open VERB VB _ 2 dep _ _\n'
        "4 it it PRON PRP _ 3 obj _ _\n5 \" \" PUNCT '' _ 3 punct _ _"
    )
    assert [word.head for word in mentioned_words.run(tree, Verbs()).words] == [0, 1, 2, 3, 3]
