"""The Stanza models: which ones, loaded how, and the parse of a sentence."""

import os
import time
from collections import OrderedDict
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, FrozenSet, List, Optional, Tuple

from utterance_passes.running import (
    run_cut_passes,
    run_surroundings_passes,
    run_tag_passes,
    run_text_passes,
    run_tree_passes,
)
from utterance_passes.spelling import Spelling, stripped
from utterance_passes.table import CUT_PASSES, PARSER_TREE_PASSES, SURROUNDINGS_PASSES, TAG_PASSES, TEXT_PASSES
from utterance_passes.trace import Trace, TraceLine, moved
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import joined, with_words_around
from utterance_passes.vocabulary import Verbs

PROCESSORS = "tokenize,mwt,pos,lemma,depparse"
#: Used where the package has it: official packages do, the shipped one does not.
CONSTITUENCY = "constituency"
#: Parsed once at start: the first sentence costs several times as much as the others.
WARM_UP = "Turn left 120 degrees."


class ModelError(RuntimeError):
    """No model, or one that cannot be loaded; the message says what was looked for, where, and what to do."""


class UnparsableText(ValueError):
    """The text holds no words."""

    @property
    def refusal(self) -> Tuple[str, str]:
        """Code and sentence of the reply."""
        return "EMPTY_TEXT", f"I cannot read that: {self}."


@dataclass(frozen=True)
class LoadTimes:
    """What the start was spent on, in seconds.

    Attributes:
        torch_s: importing torch
        stanza_s: importing Stanza
        models_s: reading the models
        warm_up_s: the first parse
    """

    torch_s: float
    stanza_s: float
    models_s: float
    warm_up_s: float

    @property
    def total_s(self) -> float:
        """All of it."""
        return self.torch_s + self.stanza_s + self.models_s + self.warm_up_s


def check_model_folder(folder: Path, package: str) -> None:
    """Check that a folder holds a Stanza package of English.

    Raises:
        ModelError: it does not
    """
    hint = "leave ~model_dir empty for the models that are shipped, or download a package with Stanza beforehand"
    if not folder.is_dir():
        raise ModelError(f"no model folder {folder} ({hint})")
    if not (folder / "resources.json").is_file():
        raise ModelError(f"{folder} holds no resources.json, so it is no folder of Stanza models ({hint})")
    for processor in PROCESSORS.split(","):
        if not any((folder / "en" / processor).glob("*.pt")):
            raise ModelError(f"{folder} holds no model for '{processor}' of the package '{package}' ({hint})")


def processors_of(folder: Path) -> str:
    """Return the processors to load from a folder, as Stanza wants them."""
    return PROCESSORS + (f",{CONSTITUENCY}" if any((folder / "en" / CONSTITUENCY).glob("*.pt")) else "")


@dataclass(frozen=True)
class Parse:
    """A parse, and what the passes of the parser did on the way.

    Attributes:
        tree: Universal Dependencies; positions of characters are those of the text as it was said
        trace: what each pass changed
    """

    tree: DependencyTree
    trace: Tuple[TraceLine, ...]


class Parser:
    """Parses sentences with one Stanza package; nothing is ever downloaded."""

    def __init__(self, *, model_dir: Path, package: str = "default", threads: int = 1, cache_size: int = 256) -> None:
        """
        Args:
            model_dir: folder with ``resources.json`` and ``en/``, as Stanza lays it out
            package: name of a package in that folder
            threads: of torch; one is fastest and steadiest for single short sentences
            cache_size: so many parses are kept, the oldest go first
        Raises:
            ModelError: no such models, or Stanza is not installed
        """
        check_model_folder(model_dir, package)
        started = time.monotonic()
        try:
            import torch

            torch_done = time.monotonic()
            import stanza
        except ImportError as error:
            raise ModelError(
                f"Stanza is not installed for this Python ({error}): run 'make setup', or 'pip install stanza'"
            ) from error
        torch.set_num_threads(threads)
        self._inference_mode: Any = torch.inference_mode
        stanza_done = time.monotonic()
        try:
            self._pipeline: Any = stanza.Pipeline(
                "en",
                dir=str(model_dir),
                package=package,
                processors=processors_of(model_dir),
                download_method=None,
                use_gpu=False,
                tokenize_no_ssplit=True,
                logging_level="ERROR",
            )
        except Exception as error:  # boundary: Stanza raises many kinds of errors for a broken file
            raise ModelError(
                f"the models in {model_dir} (package '{package}') cannot be loaded: {type(error).__name__}: {error}"
            ) from error
        models_done = time.monotonic()
        self._cache: OrderedDict[Tuple[str, FrozenSet[str], FrozenSet[str]], Parse] = OrderedDict()
        self._cache_size = cache_size
        self.parse(WARM_UP)
        self.load_times = LoadTimes(
            torch_s=torch_done - started,
            stanza_s=stanza_done - torch_done,
            models_s=models_done - stanza_done,
            warm_up_s=time.monotonic() - models_done,
        )

    def parse(self, text: str, verbs: FrozenSet[str] = frozenset()) -> DependencyTree:
        """Parse one utterance as one sentence.

        Args:
            text: as it was said
            verbs: verbs of the lexicon, base forms in lower case: one of them at the front of a command is its verb
        Returns:
            its Universal Dependencies; positions of characters are those of the text as it was said
        Raises:
            UnparsableText: no words
        """
        return self.traced(text, verbs).tree

    def traced(self, text: str, verbs: FrozenSet[str] = frozenset(), *, without: FrozenSet[str] = frozenset()) -> Parse:
        """Parse one utterance, and tell what the passes of the parser did.

        Args:
            text: as it was said
            verbs: as for :meth:`parse`
            without: names of passes that are switched off
        Raises:
            UnparsableText: no words
        """
        key = (text, verbs, without)
        parse = self._cache.get(key)
        if parse is None:
            parse = self._parse(text, verbs, without)
            self._cache[key] = parse
            if len(self._cache) > self._cache_size:
                self._cache.popitem(last=False)
        else:
            self._cache.move_to_end(key)
        return parse

    def _parse(self, text: str, verbs: FrozenSet[str], without: FrozenSet[str]) -> Parse:
        trace = Trace()
        spelling = run_text_passes(text, TEXT_PASSES, without=without, trace=trace)
        if not any(character.isalnum() for character in spelling.text):
            raise UnparsableText("there are no words in it")
        with self._inference_mode():
            tree = self._tree(text, spelling, _Run(Verbs(verbs), without, trace))
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
        document = self._pipeline(spelling.text)
        words = document.sentences[0].words
        forms, tags = [word.text for word in words], [word.upos for word in words]
        # Without a verb nothing is known better than by the tagger.
        is_known = bool(run.vocabulary.words)
        cuts = run_cut_passes(
            forms, tags, run.vocabulary, CUT_PASSES if is_known else (), without=run.without, trace=run.trace
        )
        if cuts:
            bounds = [0, *(_start(words[position - 1]) for position in cuts), len(spelling.text)]
            parts = [spelling.part(start, end) for start, end in zip(bounds, bounds[1:])]
            runs = [replace(run, trace=Trace()) for _ in parts]
            trees = [self._tree(text, stripped(part), each) for part, each in zip(parts, runs)]
            whole = joined(text, trees)
            for tree, each in zip(trees, runs):
                run.trace.extend(moved(each.trace.lines, tree, whole))
            return whole
        retags = run_tag_passes(
            forms, tags, run.vocabulary, TAG_PASSES if is_known else (), without=run.without, trace=run.trace
        )
        for retag in retags:
            word = words[retag.position - 1]
            word.upos, word.xpos, word.feats = retag.upos, retag.xpos, retag.feats or None
            word.lemma = word.text.lower()
        if retags:
            document = self._pipeline.processors["depparse"].process(document)
        tree = _to_tree(text, document.sentences[0], spelling)
        return run_tree_passes(tree, run.vocabulary, PARSER_TREE_PASSES, without=run.without, trace=run.trace)


@dataclass(frozen=True)
class _Run:
    """What one parse goes by, and where it is written."""

    vocabulary: Verbs
    without: FrozenSet[str]
    trace: Trace


def _start(word: Any) -> int:
    """Return where a word begins; the words of a multi-word token begin where it does."""
    return int(word.start_char if word.start_char is not None else word.parent.start_char)


def _to_tree(text: str, sentence: Any, spelling: Spelling) -> DependencyTree:
    words: List[Word] = []
    for token in sentence.tokens:
        at = token.start_char
        for word in token.words:
            # The words of a multi-word token ("don't") are written one after the other where their letters allow it.
            start = at if spelling.text[at : at + len(word.text)] == word.text else token.start_char
            end = start + len(word.text) if start == at else token.end_char
            at = min(end, token.end_char)
            words.append(
                Word(
                    index=word.id,
                    form=word.text,
                    lemma=word.lemma or word.text,
                    upos=word.upos or "X",
                    xpos=word.xpos or "",
                    feats=word.feats or "",
                    head=word.head,
                    deprel=word.deprel,
                    start_character=spelling.origins[start],
                    end_character=spelling.origins[min(end, len(spelling.origins) - 1)],
                )
            )
    constituency = getattr(sentence, CONSTITUENCY, None)
    return DependencyTree(text=text, words=tuple(words), brackets=str(constituency) if constituency is not None else "")


def shipped_model_dir(package_share: Optional[str] = None) -> Path:
    """Return the folder of the models that are shipped.

    Args:
        package_share: share folder of this package, for an install space; None for the source folder that this module
            is in
    """
    return Path(package_share) / "models" if package_share else Path(os.path.realpath(__file__)).parents[2] / "models"
