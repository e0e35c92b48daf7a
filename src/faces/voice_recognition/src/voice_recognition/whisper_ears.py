"""Hears by Whisper what can be written: what the robot knows chooses among what may have been said."""

import threading
from typing import Dict, FrozenSet, Mapping, Optional, Protocol, Sequence, Tuple

from command_server.stop_words import is_stop
from voice_recognition.agreement import Heard, Verdict, answer_of
from voice_recognition.choosing import Candidate, choose
from voice_recognition.command_reading import Meaning, Sense
from voice_recognition.ears import Ears, answers
from voice_recognition.offers import OfferFinder
from voice_recognition.recogniser import model_dictionary
from voice_recognition.sound_alike import SoundAlikes, variants
from voice_recognition.spoken_language import Words, spoken_words
from voice_recognition.spotting import CLEAR_DB, clearness_and_length, stop_text
from voice_recognition.voice_words import voice_words
from voice_recognition.whisper_client import NotHeard
from voice_recognition.whisper_model import Sentence, Transcript
from world_model import World
from world_model.world_object import Sort

#: From this probability on nobody speaks, whatever Whisper writes.
NO_SPEECH = 0.6
#: An answer that sounds less likely does not count.
ANSWER_PER_TOKEN = -1.3
#: So many words are no stop that was misheard.
FEWEST_WORDS_OF_TALK = 4
#: The logarithm of how much less likely a stop may be than what was heard, where that is nothing to the robot.
CRY_BEHIND = 6.0
#: Sentences that only sound like what was heard: those that are read, and of these those that are scored, at most.
MOST_READ, MOST_SCORED = 24, 8
#: Names in the prompt, at most.
MOST_NAMES = 12
#: Whisper writes names and commands that it has just read about.
PROMPT = (
    "Commands to a robot: stop. Emergency stop. "
    "Go to the kitchen, turn left 90 degrees, move forward 2 metres, bring me the mug."
)
NAMES_PROMPT = "Follow {names}."
CALLED_PROMPT = "{name}, come here."


class Hearer(Protocol):
    """What the ears need of Whisper."""

    def hear(self, pcm: bytes, prompt: str = "") -> Transcript:
        """Return what is said in a sound."""

    def score(self, sound: int, texts: Sequence[str]) -> Tuple[Sentence, ...]:
        """Return how likely some texts are in a sound of a transcript."""


class Reader(Protocol):
    """What the ears need of :class:`.command_reading.CommandReader`."""

    @property
    def known(self) -> FrozenSet[str]:
        """The words that the robot knows, in lower case."""

    def read(self, text: str) -> Meaning:
        """Return what the robot makes of a text."""


class WhisperEars:
    """Hears commands and answers of one robot. Another robot, or other knowledge, makes new ears."""

    def __init__(self, ears: Ears, hearer: Hearer, reader: Reader, alikes: SoundAlikes, prompt: str) -> None:
        """
        Args:
            ears: by pocketsphinx, which hear in the place of Whisper when it does not answer
            hearer: Whisper
            reader: what the robot makes of a text
            alikes: the words that the robot knows, by their sounds
            prompt: names and words that are likely
        """
        self._ears = ears
        self._hearer = hearer
        self._reader = reader
        self._alikes = alikes
        self._prompt = prompt
        self._lock = threading.Lock()
        self._last: Tuple[bytes, Transcript] = (b"", Transcript())

    @property
    def finder(self) -> OfferFinder:
        """Reads words by the templates of the language."""
        return self._ears.finder

    def read_by(self, reader: Reader) -> None:
        """Read from now on by what the robot knows of the same things, persons and places.

        Args:
            reader: knows of the same names
        """
        self._reader = reader

    @property
    def by_pocketsphinx(self) -> Ears:
        """The ears that hear when Whisper does not answer."""
        return self._ears

    def hear(self, pcm: bytes) -> Heard:
        """Hear a command."""
        try:
            return self._chosen(self._transcript(pcm), pcm)
        except NotHeard:
            return self._ears.hear(pcm)

    def hear_answer(self, pcm: bytes) -> Heard:
        """Hear an answer, or a command in its place."""
        return self.hear_one_of(pcm, answers(), self._ears.hear_answer)

    def hear_one_of(self, pcm: bytes, ways: Mapping[str, Tuple[Words, ...]], otherwise: "HearSound") -> Heard:
        """Hear one of some answers, or a command in its place.

        Args:
            pcm: the sound
            ways: the phrases of each answer
            otherwise: hears it without Whisper
        """
        try:
            transcript = self._transcript(pcm)
            words = spoken_words(transcript.sentences[0].text) if transcript.sentences else ()
            answer = _answer(transcript, ways)
            if answer:
                return Heard(Verdict.SURE, (), words, words, answer=answer)
            command = self._chosen(transcript, pcm)
        except NotHeard:
            return otherwise(pcm)
        if command.is_stop or command.verdict is Verdict.SURE:
            return command
        return Heard(Verdict.AGAIN if words else Verdict.NOTHING, (), words, words)

    def hear_stop(self, pcm: bytes) -> Optional[str]:
        """Return the stop that a short utterance is, empty for none; None if Whisper cannot tell."""
        try:
            transcript = self._transcript(pcm)
        except NotHeard:
            return None
        heard = _spelled_once(transcript.sentences) if transcript.no_speech <= NO_SPEECH else ()
        if not heard:
            return None
        chosen = choose([Candidate(one, self._reader.read(one.text)) for one in heard])
        if chosen.is_stop:
            return stop_text(chosen.by_grammar)
        if self._is_clearly_other(heard[0]) and not any(is_stop(one.text) for one in heard):
            return ""
        return self._cry_in(transcript, heard[0])

    def _cry_in(self, transcript: Transcript, heard: Sentence) -> Optional[str]:
        """Return the stop that is nearly as likely as what was heard; None if there is none."""
        cries = self._hearer.score(transcript.sound, [" ".join(words) for words in voice_words().cries])
        likeliest = max(cries, key=lambda one: one.log_probability, default=None)
        if likeliest is None or likeliest.log_probability < heard.log_probability - CRY_BEHIND:
            return None
        return stop_text(spoken_words(likeliest.text))

    def _is_clearly_other(self, sentence: Sentence) -> bool:
        """Whether what was heard is a command, or a sentence of talk: one or two words may be a stop, misheard."""
        if sentence.per_token < ANSWER_PER_TOKEN:
            return False
        is_long = len(spoken_words(sentence.text)) >= FEWEST_WORDS_OF_TALK
        return is_long or self._reader.read(sentence.text).sense >= Sense.ASKED

    def _transcript(self, pcm: bytes) -> Transcript:
        """Return what Whisper hears; a stop and a command are looked for in the same sound, which is heard once."""
        with self._lock:
            if self._last[0] != pcm:
                self._last = (pcm, self._hearer.hear(pcm, self._prompt))
            return self._last[1]

    def _chosen(self, transcript: Transcript, pcm: bytes) -> Heard:
        if transcript.no_speech > NO_SPEECH or not transcript.sentences:
            return Heard(Verdict.NOTHING)
        heard = _spelled_once(transcript.sentences)
        candidates = [Candidate(one, self._reader.read(one.text)) for one in heard]
        best = max(candidates, key=lambda one: one.weight)
        if best.meaning.sense >= Sense.COMMAND and not best.meaning.unknown and best.sentence is heard[0]:
            return choose(candidates)
        more = {**self._more_meanings(heard), **self._meaning_by_grammar(pcm)}
        candidates += [
            Candidate(one, more[one.text], is_heard=False) for one in self._hearer.score(transcript.sound, list(more))
        ]
        return choose(candidates)

    def _meaning_by_grammar(self, pcm: bytes) -> Dict[str, Meaning]:
        """Return what pocketsphinx hears in noise: forced into a grammar of commands, it misses them less often."""
        if clearness_and_length(pcm)[0] >= CLEAR_DB:
            return {}
        text = self._alikes.written(self._ears.hear(pcm).by_grammar)
        meaning = self._reader.read(text) if text else Meaning(Sense.NONE)
        return {text: meaning} if meaning.sense in (Sense.ASKED, Sense.COMMAND) else {}

    def _more_meanings(self, heard: Sequence[Sentence]) -> Dict[str, Meaning]:
        """Return what sounds like what was heard, where the robot makes something of it."""
        taken = {spoken_words(one.text) for one in heard}
        found: Dict[str, Meaning] = {}
        likely: Dict[str, float] = {}
        for one in heard[:3]:
            for difference, words in variants(spoken_words(one.text), self._reader.known, self._alikes):
                if words not in taken:
                    text = self._alikes.written(words)
                    likely[text] = min(difference, likely.get(text, difference))
        for text in sorted(likely, key=lambda text: likely[text])[:MOST_READ]:
            meaning = self._reader.read(text)
            if meaning.sense in (Sense.ASKED, Sense.COMMAND) and not meaning.unknown and len(found) < MOST_SCORED:
                found[text] = meaning
        return found


class HearSound(Protocol):
    """Hears a sound."""

    def __call__(self, pcm: bytes, /) -> Heard:
        """Return what is heard."""


def _spelled_once(sentences: Sequence[Sentence]) -> Tuple[Sentence, ...]:
    """Return the sentences of other words, each in its likeliest spelling, the likeliest first."""
    found: Dict[Words, Sentence] = {}
    for one in sorted(sentences, key=lambda one: -one.log_probability):
        found.setdefault(spoken_words(one.text), one)
    return tuple(one for words, one in found.items() if words)


def _answer(transcript: Transcript, ways: Mapping[str, Tuple[Words, ...]]) -> str:
    """Return the one answer that is among the sentences, if the first one is it; empty for none, or several."""
    if not transcript.sentences or transcript.no_speech > NO_SPEECH:
        return ""
    first = transcript.sentences[0]
    found = {answer_of(spoken_words(one.text), ways) for one in transcript.sentences} - {""}
    said = answer_of(spoken_words(first.text), ways)
    return said if found == {said} and first.per_token >= ANSWER_PER_TOKEN else ""


def prompt_with(names: Sequence[str], called: Sequence[str] = ()) -> str:
    """Return what Whisper reads before it hears.

    Args:
        names: of persons, that the robot knows
        called: names by which it is called
    """
    calls = [CALLED_PROMPT.format(name=name.title()) for name in called[:MOST_NAMES]]
    persons = sorted(names)[:MOST_NAMES]
    follow = [NAMES_PROMPT.format(names=", ".join(persons))] if persons else []
    return " ".join([*calls, PROMPT, *follow])


def make_whisper_ears(
    ears: Ears, hearer: Hearer, reader: Reader, world: World, called: Sequence[str] = ()
) -> WhisperEars:
    """Make ears with the dictionary of pocketsphinx.

    Args:
        ears: by pocketsphinx
        hearer: Whisper
        reader: what the robot makes of a text
        world: whose persons are named to Whisper
        called: names by which the robot is called
    Raises:
        NoRecogniser: pocketsphinx is not installed
    """
    persons = [(one.name or one.id).capitalize() for one in world.objects if one.sort is Sort.PERSON]
    places = [name for one in world.objects if one.sort is Sort.PLACE for name in one.names]
    # "Robot" is said to any robot.
    unusual = [name for name in called if (name.lower(),) not in voice_words().polite_before]
    names = [word for name in (*persons, *places, *map(str.title, unusual)) for word in name.split()]
    alikes = SoundAlikes(reader.known, names, model_dictionary())
    return WhisperEars(ears, hearer, reader, alikes, prompt_with(persons, unusual))
