"""Hears the answer to a question of the pipeline: yes, no, or one of the things that the question names."""

from typing import Dict, Mapping, Sequence, Set, Tuple

from command_server.answers import YES_NO
from voice_recognition.agreement import Heard, Verdict, compare_answers
from voice_recognition.class_ngram import write_ngram
from voice_recognition.denoising import without_noise
from voice_recognition.ears import Ears
from voice_recognition.grammar import write_phrases
from voice_recognition.pronunciation import Dictionary, pronounce
from voice_recognition.recogniser import PocketSphinx
from voice_recognition.spoken_language import Words, spoken_words
from voice_recognition.voice_words import voice_words

Ways = Mapping[str, Tuple[Words, ...]]
_GRAMMAR, _FREE = "answers", "free"


def ways_of(answers: Sequence[str]) -> Ways:
    """Return how each answer can be said: its text, and its phrases.

    Args:
        answers: to choose from; yes and no for a question that is answered by them
    """
    words = voice_words()
    yes, no = YES_NO
    if tuple(answers) == YES_NO:
        return {yes: words.answers["yes"], no: words.answers["no"]}
    found: Dict[str, Tuple[Words, ...]] = {}
    taken: Set[Words] = set()
    for number, answer in enumerate(answers):
        said = spoken_words(answer)
        phrases = [said, said[1:] if len(said) > 1 and said[0] in words.before_things else said]
        phrases += words.answers[("first", "second")[number]] if len(answers) > 1 and number < 2 else ()
        found[answer] = tuple(one for one in dict.fromkeys(phrases) if one and one not in taken)
        taken.update(found[answer])
    return {**found, no: tuple(one for one in words.answers["no"] if one not in taken)}


class ReplyEars:
    """Hears the answers to one question. Another question makes new ears."""

    def __init__(self, answers: Sequence[str], known: Dictionary) -> None:
        """
        Args:
            answers: to choose from
            known: sounds of words; espeak-ng says those of other words
        Raises:
            NoRecogniser: it is not installed
        """
        words = voice_words()
        self.ways = ways_of(answers)
        phrases = tuple(phrase for ways in self.ways.values() for phrase in ways) + words.stop
        around = [word for phrase in phrases for word in phrase]
        dictionary, unknown = pronounce([*words.other_words, *around], known)
        said = tuple(phrase for phrase in phrases if not unknown & set(phrase))
        self._recogniser = PocketSphinx(
            dictionary,
            grammars={_GRAMMAR: write_phrases(said)},
            ngrams={_FREE: write_ngram(None, words.other_words, phrases=said, without=unknown)},
        )

    def hear(self, pcm: bytes, commands: Ears) -> Heard:
        """Hear an answer, which both searches have to hear, or a command in its place."""
        quiet = without_noise(pcm)
        by_ngram = self._recogniser.hear(_FREE, quiet).words
        answer = compare_answers(self._recogniser.hear(_GRAMMAR, quiet).words, by_ngram, self.ways)
        if answer.answer or answer.is_stop:
            return answer
        command = commands.hear(pcm)
        return command if command.verdict is Verdict.SURE or command.is_stop else answer
