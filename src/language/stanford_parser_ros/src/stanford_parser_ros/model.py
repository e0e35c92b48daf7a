"""Parses sentences: what the models say, and what the passes of the parser make of it."""

import re
from collections import OrderedDict
from dataclasses import dataclass, replace
from typing import FrozenSet, Tuple

from stanford_parser_ros.inference import Inference, shipped_model_dir
from stanford_parser_ros.joint.inference import JointInference
from stanford_parser_ros.joint.lexicon_hints import RULE, Hint, named_words
from stanford_parser_ros.verb_lemmas import with_verb_lemmas
from utterance_passes.engine.running import (
    run_cut_passes,
    run_surroundings_passes,
    run_text_passes,
    run_word_passes,
)
from utterance_passes.engine.trace import Trace, TraceLine, moved
from utterance_passes.table import CUT_PASSES, SURROUNDINGS_PASSES, TEXT_PASSES, WORD_PASSES
from utterance_passes.trees.spelling import Spelling, stripped
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.tree_edits import at_origins, joined, with_words_around
from utterance_passes.trees.vocabulary import Verbs
from word_classes import in_words

#: Words and other signs of an utterance. The time and memory of the models grow with the square of their number, and
#: torch keeps the memory: with 500 of them, 1.4 GB. The longest utterance in the corpora has 80.
MOST_WORDS = 100
_WORD = re.compile(r"\w+|[^\w\s]")


@dataclass(frozen=True)
class KnownWords:
    """Words that the robot knows, in lower case.

    Attributes:
        verbs: first words of the verbs of the lexicon, base forms
        spellings: words of the lexicon, whose typos are corrected; none to correct nothing
        names: words of the names that the robot knows
        hints: what the units say of the words of their verbs
    """

    verbs: FrozenSet[str] = frozenset()
    spellings: FrozenSet[str] = frozenset()
    names: FrozenSet[str] = frozenset()
    hints: FrozenSet[Hint] = frozenset()


NO_WORDS = KnownWords()


class UnparsableText(ValueError):
    """The text holds no words, or too many.

    Attributes:
        refusal: code and sentence of the reply
    """

    def __init__(self, reason: str, *, code: str) -> None:
        """
        Args:
            reason: a clause, without a full stop
            code: of the reply
        """
        super().__init__(reason)
        self.refusal = (code, f"I cannot read that: {reason}.")


@dataclass(frozen=True)
class Parse:
    """A parse, and the changes that the passes of the parser made.

    Attributes:
        tree: Universal Dependencies; positions of characters are those of the text as it was said
        trace: what each pass changed
    """

    tree: DependencyTree
    trace: Tuple[TraceLine, ...]


class Parser:
    """Parses sentences: asks the models, and runs the passes of the parser before and after."""

    def __init__(self, inference: Inference, *, cache_size: int = 256) -> None:
        """
        Args:
            inference: the models
            cache_size: number of parses that are kept; the oldest is dropped first
        """
        self._inference = inference
        self._cache: OrderedDict[Tuple[str, KnownWords, FrozenSet[str]], Parse] = OrderedDict()
        self._cache_size = cache_size

    def parse(self, text: str, verbs: FrozenSet[str] = frozenset()) -> DependencyTree:
        """Parse one utterance as one sentence.

        Args:
            text: the utterance
            verbs: verbs of the lexicon, base forms in lower case; one of them at the front of a command is its verb
        Returns:
            its Universal Dependencies; positions of characters are those of the text as it was said
        Raises:
            UnparsableText: the text has no words, or too many
        """
        return self.traced(text, KnownWords(verbs)).tree

    def traced(self, text: str, known: KnownWords = NO_WORDS, *, without: FrozenSet[str] = frozenset()) -> Parse:
        """Parse one utterance, and record what the passes of the parser changed.

        Args:
            text: the utterance
            known: words that the robot knows
            without: names of passes that are switched off
        Raises:
            UnparsableText: the text has no words, or too many
        """
        key = (text, known, without)
        parse = self._cache.get(key)
        if parse is None:
            parse = self._parse(text, known, without)
            self._cache[key] = parse
            if len(self._cache) > self._cache_size:
                self._cache.popitem(last=False)
        else:
            self._cache.move_to_end(key)
        return parse

    def _parse(self, text: str, known: KnownWords, without: FrozenSet[str]) -> Parse:
        trace = Trace()
        vocabulary = Verbs(known.verbs, spellings=known.spellings, names=known.names)
        spelling = run_text_passes(in_words(text), TEXT_PASSES, without=without, trace=trace)
        spelling = run_word_passes(spelling, vocabulary, WORD_PASSES, without=without, trace=trace)
        if not any(character.isalnum() for character in spelling.text):
            raise UnparsableText("there are no words in it", code="EMPTY_TEXT")
        count = len(_WORD.findall(spelling.text))
        if count > MOST_WORDS:
            raise UnparsableText(f"it has {count} words and signs; I accept at most {MOST_WORDS}", code="TEXT_TOO_LONG")
        tree = self._tree(text, spelling, _Run(vocabulary, known.hints, without, trace))
        return Parse(tree, trace.lines)

    def _tree(self, text: str, spelling: Spelling, run: "_Run") -> DependencyTree:
        """Parse a command alone, and put around its tree what is said around it."""
        around = run_surroundings_passes(
            spelling, run.vocabulary, SURROUNDINGS_PASSES, without=run.without, trace=run.trace
        )
        if around is None:
            return self._tree_of_commands(text, spelling, run)
        inner = replace(run, trace=Trace())
        command = self._tree_of_commands(text, around.command, inner)
        whole = with_words_around(command, text, around.verb, around.base, around.words)
        run.trace.extend(moved(inner.trace.lines, command, whole))
        return whole

    def _tree_of_commands(self, text: str, spelling: Spelling, run: "_Run") -> DependencyTree:
        """Parse one command, or each of several."""
        tree = self._parsed(spelling, run)
        forms, tags = [word.form for word in tree.words], [word.upos for word in tree.words]
        # Without known verbs the tagger knows best.
        is_known = bool(run.vocabulary.words)
        cuts = run_cut_passes(
            forms, tags, run.vocabulary, CUT_PASSES if is_known else (), without=run.without, trace=run.trace
        )
        if cuts:
            bounds = [0, *(tree.word(position).start_character for position in cuts), len(spelling.text)]
            parts = [spelling.part(start, end) for start, end in zip(bounds, bounds[1:])]
            runs = [replace(run, trace=Trace()) for _ in parts]
            trees = [self._tree(text, stripped(part), each) for part, each in zip(parts, runs)]
            whole = joined(text, trees)
            for tree, each in zip(trees, runs):
                run.trace.extend(moved(each.trace.lines, tree, whole))
            return whole
        return at_origins(tree, text, spelling.origins)

    def _parsed(self, spelling: Spelling, run: "_Run") -> DependencyTree:
        """Ask the models, and ask them again where a word is something else than the units say."""
        tree = with_verb_lemmas(self._inference.parse(spelling.text))
        named = named_words(tree, run.hints) if RULE not in run.without else ()
        if not named:
            return tree
        found = with_verb_lemmas(self._inference.with_named_words(tree, named))
        run.trace.add_changes(RULE, tree, found)
        return found


@dataclass(frozen=True)
class _Run:
    """What one parse goes by, and where it is written."""

    vocabulary: Verbs
    hints: FrozenSet[Hint]
    without: FrozenSet[str]
    trace: Trace


def shipped_parser(*, cache_size: int = 256) -> Parser:
    """Return a parser with the shipped models.

    Args:
        cache_size: number of parses that are kept
    Raises:
        ModelError: the models are missing, or ONNX Runtime is not installed
    """
    return Parser(JointInference(model_dir=shipped_model_dir()), cache_size=cache_size)
