"""Sentences of refusals and questions read as a person would write them."""

from semantic_framer.values.outcome import left_over_refusal
from semantic_framer.values.sentence import Sentence
from utterance_passes.trees.conllu import from_conllu

PING_SIDEWAYS = "\n".join(
    f"{index}\t{form}\t{form}\t{upos}\t_\t_\t{head}\t{deprel}\t_\t_"
    for index, form, upos, head, deprel in [
        (1, "Ping", "VERB", 0, "root"),
        (2, ",", "PUNCT", 1, "punct"),
        (3, "sideways", "ADV", 1, "advmod"),
        (4, ".", "PUNCT", 1, "punct"),
    ]
)


def test_left_over_words_are_quoted_without_punctuation() -> None:
    refusal = left_over_refusal(Sentence(from_conllu(PING_SIDEWAYS + "\n\n")), [2, 3, 4])
    assert refusal.left_over == ("sideways",)
    assert refusal.sentence.startswith('I do not understand "sideways" in ')
