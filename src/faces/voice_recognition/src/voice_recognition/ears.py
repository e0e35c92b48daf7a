"""Hears a language: makes the searches for it, and compares what they hear."""

from typing import FrozenSet, Mapping, Tuple

from voice_recognition.agreement import Heard, Verdict, compare, compare_answers
from voice_recognition.class_ngram import write_ngram
from voice_recognition.denoising import without_noise
from voice_recognition.grammar import write_grammar, write_phrases
from voice_recognition.offers import OfferFinder
from voice_recognition.pronunciation import Dictionary, pronounce
from voice_recognition.recogniser import PocketSphinx, Recogniser, model_dictionary
from voice_recognition.spoken_language import SpokenLanguage, Words
from voice_recognition.voice_words import voice_words

COMMANDS, ANSWERS, FREE, FREE_ANSWERS = "commands", "answers", "free", "free_answers"


class Ears:
    """Hears commands of one language, and answers. A new language makes new ears."""

    def __init__(self, language: SpokenLanguage, recogniser: Recogniser, unpronounceable: FrozenSet[str]) -> None:
        """
        Args:
            language: what can be said
            recogniser: with the searches ``COMMANDS``, ``ANSWERS``, ``FREE`` and ``FREE_ANSWERS``
            unpronounceable: words that it cannot hear
        """
        self.language = language
        self.unpronounceable = unpronounceable
        self._recogniser = recogniser
        self._finder = OfferFinder(language)

    @property
    def finder(self) -> OfferFinder:
        """Reads words by the templates of the language."""
        return self._finder

    def hear(self, pcm: bytes) -> Heard:
        """Hear a command."""
        return self._hear(without_noise(pcm))

    def _hear(self, pcm: bytes) -> Heard:
        by_grammar = self._recogniser.hear(COMMANDS, pcm).words
        if not by_grammar:
            return Heard(Verdict.NOTHING)
        return compare(by_grammar, self._recogniser.hear(FREE, pcm).words, self._finder)

    def hear_answer(self, pcm: bytes) -> Heard:
        """Hear an answer, or a command in its place."""
        pcm = without_noise(pcm)
        by_ngram = self._recogniser.hear(FREE_ANSWERS, pcm).words
        answer = compare_answers(self._recogniser.hear(ANSWERS, pcm).words, by_ngram, answers())
        if answer.answer or answer.is_stop:
            return answer
        command = self._hear(pcm)
        return command if command.verdict is Verdict.SURE or command.is_stop else answer


def answers() -> Mapping[str, Tuple[Words, ...]]:
    """Return the answers that can be heard."""
    return voice_words().answers


def make_ears(language: SpokenLanguage, known: Dictionary) -> Ears:
    """Make the searches for a language.

    Args:
        language: what can be said
        known: sounds of words; espeak-ng says those of other words
    Raises:
        NoRecogniser: it is not installed
    """
    words = voice_words()
    phrases = tuple(phrase for ways in words.answers.values() for phrase in ways) + words.stop
    around = [word for phrase in phrases + words.polite_before + words.polite_after for word in phrase]
    dictionary, unknown = pronounce([*language.vocabulary(), *words.other_words, *around], known)
    recogniser = PocketSphinx(
        dictionary,
        grammars={
            COMMANDS: write_grammar(language, phrases=words.stop, without=unknown),
            ANSWERS: write_phrases(phrases),
        },
        ngrams={
            FREE: write_ngram(language, words.other_words, phrases=words.stop, without=unknown),
            FREE_ANSWERS: write_ngram(None, words.other_words, phrases=phrases, without=unknown),
        },
    )
    return Ears(language, recogniser, unknown)


def make_shipped_ears(language: SpokenLanguage) -> Ears:
    """Make ears with the dictionary of the acoustic model.

    Raises:
        NoRecogniser: it is not installed
    """
    return make_ears(language, model_dictionary())
