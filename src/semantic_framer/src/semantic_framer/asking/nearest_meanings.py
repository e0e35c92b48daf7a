"""Asks what a sentence means that cannot be done as it stands: 'By "make your way to the hall", do you mean ...?'

Candidates are the sentence without the words that nothing reads, and the sentence with another verb in the place of one
that is not known: a verb of its class, or the verb of an example that is like the sentence. A candidate counts only if
the framer understands it as a command, with all of its words. So nothing is asked that could not be done, and the
verdicts on commands hold for candidates, too.
"""

from dataclasses import dataclass, replace
from typing import Dict, FrozenSet, Iterable, Iterator, List, NamedTuple, Optional, Sequence, Set, Tuple

from roboframenet_ros.spoken_text import join_with_and, join_with_or
from semantic_framer.asking.settling import Now
from semantic_framer.clauses.readings import Heard, Read
from semantic_framer.kinds.utterance_kind import kinds_of_clauses
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.dialogue import Context, Lesson, Pending
from semantic_framer.values.outcome import LeftOverWords, Question, Refusal, Understood
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit
from semantic_types.verb_classes import SYNONYM, known_verbs_near
from semantic_types.wordnet import VERB, NoWordNet, shipped_wordnet
from utterance_passes.engine.utterance_pass import Choice
from utterance_passes.phrases.clauses import find_clauses
from utterance_passes.trees.tree import VERBS, DependencyTree, Word
from utterance_passes.trees.tree_edits import NotATree, rephrased
from word_classes import word_class

#: Name of the rule in the trace.
RULE = "nearest_meaning"
#: Replies in place of which it is asked.
_NOT_UNDERSTOOD = frozenset(["LEFT_OVER_WORDS", "UNKNOWN_VERB", "NO_READING", "VALUE_NOT_ALLOWED"])
#: Replies to which it is added what can be done that is near.
_UNKNOWN_DEEDS = frozenset(["UNKNOWN_VERB", "NO_READING"])
#: What is less like a sentence is not near.
_NEAR = 0.45
#: Words that turn a command round, or limit it: nobody is asked to do without them.
_LIMITING = (
    word_class("negations")
    | word_class("exceptions_of_all")
    | word_class("conditions")
    | word_class("reason_conjunctions")
    | word_class("restricting_adverbs")
    | {"stop", "without"}
)
#: Words that go with the word that they hang on.
_OF_GRAMMAR = frozenset(["case", "det", "mark", "cc", "punct", "aux", "fixed", "nmod:poss", "cop", "discourse", "expl"])
_SIDES = word_class("left_and_right")
_CONTENT = frozenset(["NOUN", "PROPN", "VERB", "ADJ", "ADV", "NUM", "PRON"])
#: Relations of words without which another thing would be done.
_NEVER_LEFT_OUT = frozenset(["root", "obj", "iobj", "nsubj", "compound", "conj"])
#: Relations of words that are part of an idiom: "make *your* way", "have *a good* look".
_OF_IDIOMS = frozenset(["det", "nmod:poss", "amod"])
#: The role of elements that say which way, and the relations of words that may say it.
_DIRECTION = "Direction"
_COMPARATIVE = "Degree=Cmp"
_OF_WAYS = frozenset(["obl", "advmod", "compound:prt"])
_LONGEST_IDIOM = 3
#: Phrases that are left out as a whole.
_PHRASES = frozenset(["obl", "nmod", "advmod", "acl", "advcl", "appos", "conj", "parataxis", "nummod", "amod", "dep"])
#: So many sentences without some words are tried.
_MOST_TRIED_WITHOUT = 8
_MOST_TRIED = 8
MOST_CANDIDATES = 3
#: A candidate of less merit is not asked about.
_LEAST_MERIT = 0.58
#: A verb of the class of the one that was said has so much more merit.
_OF_CLASS = 0.2
#: A verb that is only like a single one needs so much more merit.
_OF_KNOWN_WORDS = 0.07
#: The likeness of what cannot be compared.
_UNKNOWN = 0.5
#: A candidate that leaves an element open has so much less merit.
_OPEN = 0.05
#: The second candidate is named, too, if it is so near to the first one.
_CLOSE = 0.02


@dataclass(frozen=True)
class Candidate:
    """What a sentence may mean.

    Attributes:
        choice: the sentence that is offered, with its tree
        frames: of its clauses
        merit: how near it is
        reason: why
        lesson: what a yes teaches; None for nothing
    """

    choice: Choice
    frames: Tuple[str, ...]
    merit: float
    reason: str
    lesson: Optional[Lesson] = None


class _Gap(NamedTuple):
    """Words for which another verb may stand.

    Attributes:
        place: position of the first one
        positions: of all of them
        said: in the words of a lexical unit, "make your way"
    """

    place: int
    positions: FrozenSet[int]
    said: str


def asked_about(tree: DependencyTree, heard: Heard, context: Context, now: Now, read: Read) -> Heard:
    """Return what a sentence means, or the question what is meant if it cannot be done as it stands.

    Args:
        tree: as the parser has it
        heard: what that means
        context: what the framer remembers of earlier utterances
        now: the circumstances of the utterance
        read: understands another tree, without a trace
    """
    if not _may_ask(tree, heard, context, now):
        return heard
    found = candidates_of(tree, heard, now, read)
    for candidate in found:
        now.write(RULE, candidate.choice.text, f"may be meant: {candidate.merit:.2f}. {candidate.reason}")
    problem = now.known.likeness.problem if now.known.likeness is not None else ""
    if problem:
        now.write(RULE, tree.text, f"Sentences are not compared: {problem}")
    if not found:
        return _with_what_is_near(tree, heard, now.known)
    offered = found[: 1 + (len(found) > 1 and found[0].merit - found[1].merit < _CLOSE)]
    choices = tuple(one.choice for one in offered)
    lessons = tuple(one.lesson for one in offered)
    pending = Pending((), 0, (), now.expires_s, readings=choices, lessons=lessons)
    said = tree.text.strip(" .!?")
    quoted = [f'"{choice.text}"' for choice in choices]
    question = f'By "{said}", do you mean {join_with_or(quoted)}?'
    now.write(RULE, said, f"asked. {offered[0].reason}")
    return replace(heard, outcome=Question("CONFIRM", question), context=replace(context, pending=pending))


def _with_what_is_near(tree: DependencyTree, heard: Heard, known: FramedLexicon) -> Heard:
    """Return a refusal that also says what can be done that is near: "I can go, look and bring."."""
    outcome = heard.outcome
    if not isinstance(outcome, Refusal) or outcome.code not in _UNKNOWN_DEEDS or known.likeness is None:
        return heard
    deeds = known.lexicon.deeds(known.frames)
    alike = zip(known.likeness.of(tree.text.strip(" .!?"), deeds.texts), deeds.examples)
    usual = {unit.frame_name: verb for unit, verb in reversed(deeds.verbs)}
    near: List[str] = []
    for merit, example in sorted(alike, key=lambda one: -one[0]):
        if merit < _NEAR or len(near) == MOST_CANDIDATES:
            break
        name = example.unit.frame_name
        if name in usual and usual[name] not in near and (not known.heeded or name in known.heeded):
            near.append(usual[name])
    told = f"{outcome.sentence} I can {join_with_and(near)}." if near else outcome.sentence
    return replace(heard, outcome=replace(outcome, sentence=told))


def _may_ask(tree: DependencyTree, heard: Heard, context: Context, now: Now) -> bool:
    """Whether a sentence commands something, and nothing else is to be asked."""
    policy = now.policy
    if RULE in now.known.without or not policy.confirms or policy.left_over_words is not LeftOverWords.ASK:
        return False
    outcome = heard.outcome
    if not isinstance(outcome, Refusal) or outcome.code not in _NOT_UNDERSTOOD or heard.is_small_talk:
        return False
    if heard.is_answer or context.pending is not None or heard.context.pending is not None or heard.sentence is None:
        return False
    if any(word.said in _LIMITING for word in tree.words):
        return False
    if any(reading.unheeded for one in heard.clauses for reading in one.kept[:1]):
        return False  # It is understood, and no server takes it into account.
    clauses = find_clauses(heard.sentence.tree, now.known)
    return all(kind.acts for kind in kinds_of_clauses(heard.sentence.tree, clauses, now.known))


def candidates_of(tree: DependencyTree, heard: Heard, now: Now, read: Read) -> Tuple[Candidate, ...]:
    """Return what a sentence may mean, the nearest first; see :func:`asked_about`."""
    found: List[Candidate] = []
    without = _without_unread(tree, heard, now.known, read)
    if without is not None:
        found.append(without)
    else:
        found += _with_other_verbs(tree, heard, now.known, read)
    different: Dict[Tuple[str, ...], Candidate] = {}
    for candidate in sorted(found, key=lambda one: -one.merit):
        if all(candidate.choice.text != other.choice.text for other in different.values()):
            different.setdefault(candidate.frames, candidate)
    return tuple(different.values())[:MOST_CANDIDATES]


def _without_unread(tree: DependencyTree, heard: Heard, known: FramedLexicon, read: Read) -> Optional[Candidate]:
    """Return a sentence without the words that nothing reads, and with as many others as can stay.

    What cannot be read is left out alone, with what hangs on it, or with the phrase that it is in; what is refused then
    for other words is tried again without those, the sentence with the most words first.
    """
    before = {reading.unit.frame_name for one in heard.clauses for reading in one.plausible[:1]}
    frames_before = [known.frames[name] for name in before]
    tried: Set[FrozenSet[int]] = set()
    waiting: List[Tuple[FrozenSet[int], Heard]] = [(frozenset(), heard)]
    while waiting and len(tried) < _MOST_TRIED_WITHOUT:
        left_out, refused = waiting.pop(0)
        for more in _enlarged(tree, left_out, refused):
            is_allowed = not any(_is_needed(tree.word(index), more, frames_before) for index in more)
            if more in tried or not is_allowed or not _says_most(tree, more):
                continue
            tried.add(more)
            try:
                other = rephrased(tree, more)
            except NotATree:
                continue
            instead = read(other)
            frames = _frames_done(instead, known)
            if frames and (not before or set(frames) <= before) and not _is_open(instead):
                return _candidate_without(tree, more, _choice(other, instead), frames, known)
            waiting.append((more, instead))
        waiting.sort(key=lambda one: len(one[0]))
    return None


def _candidate_without(
    tree: DependencyTree, left_out: FrozenSet[int], choice: Choice, frames: Tuple[str, ...], known: FramedLexicon
) -> Optional[Candidate]:
    if (_whole(tree), frames[0]) in known.declined:
        return None
    words = " ".join(tree.word(index).form for index in sorted(left_out) if tree.word(index).upos != "PUNCT")
    lesson = Lesson(_whole(tree), "", frames[0], tree.text)
    return Candidate(choice, frames, 1.0, f'Nothing reads "{words}".', lesson)


def _enlarged(tree: DependencyTree, left_out: FrozenSet[int], refused: Heard) -> Iterator[FrozenSet[int]]:
    """Yield larger sets of words to leave out, the smallest first, by what a refusal names."""
    outcome = refused.outcome
    if not isinstance(outcome, Refusal) or not outcome.left_over:
        return
    unread = _positions_of(tree, outcome.left_over, left_out)
    if not unread:
        return
    alone = left_out | unread
    below = alone.union(*(tree.subtree(index) for index in unread))
    phrases = alone.union(*(_phrase_around(tree, index) for index in unread))
    found = [_with_words_of_grammar(tree, one) for one in (alone, below, phrases)]
    yield from sorted(dict.fromkeys(found), key=len)


def _phrase_around(tree: DependencyTree, index: int) -> FrozenSet[int]:
    """Return the positions of the phrase that a word is in; the word alone where that is the clause."""
    word = tree.word(index)
    while word.head:
        if word.deprel.split(":")[0] in _PHRASES:
            return tree.subtree(word.index)
        word = tree.word(word.head)
    return frozenset([index])


def _is_needed(word: Word, left_out: FrozenSet[int], frames: Iterable[SemanticFrame]) -> bool:
    """Whether another thing would be done without a word: a deed, an object, a direction, or an amount of a motion.

    Words inside a phrase that is left out as a whole say nothing of the deed: "a photo of what *you* see".
    """
    elements = [element for frame in frames for element in frame.frame_elements]
    values = {part for element in elements for value in element.values for part in value.split()}
    is_measured = any(element.quantity is not None for element in elements)
    is_amount = is_measured and (word.upos == "NUM" or any(letter.isdigit() for letter in word.form))
    if is_amount or word.said in _SIDES or word.said in values:
        return True
    if word.head in left_out:
        return False
    # "Drive *in reverse* 1 metre", "go *sideways*" say which way; "closer" does not.
    has_direction = any(element.framenet == _DIRECTION for element in elements)
    is_way = is_measured and has_direction and word.deprel in _OF_WAYS and _COMPARATIVE not in word.feats
    return is_way or word.deprel.split(":")[0] in _NEVER_LEFT_OUT


def _says_most(tree: DependencyTree, left_out: FrozenSet[int]) -> bool:
    """Whether the words that stay are at least as many as those that are left out, words of grammar apart."""
    content = [word.index for word in tree.words if word.upos in _CONTENT]
    return 2 * len(left_out.intersection(content)) <= len(content)


def _whole(tree: DependencyTree) -> str:
    """Return a whole sentence as what was said: a no to doing without some of its words holds for it alone."""
    return " ".join(tree.text.lower().strip(" .!?").split())


def _positions_of(tree: DependencyTree, forms: Sequence[str], left_out: FrozenSet[int]) -> FrozenSet[int]:
    """Return the positions of words that a refusal names, in their order as far as possible."""
    found: Set[int] = set()
    last = 0
    for form in forms:
        same = [w.index for w in tree.words if w.said == form.lower() and w.index not in found | left_out]
        behind = [index for index in same if index > last] or same
        if behind:
            last = behind[0]
            found.add(last)
    return frozenset(found)


def _with_words_of_grammar(tree: DependencyTree, positions: FrozenSet[int]) -> FrozenSet[int]:
    """Add the words of grammar that hang on words, and what lies below them if nothing there is said for itself."""
    found = set(positions)
    for index in sorted(positions):
        for child in tree.children(index):
            below = tree.subtree(child.index)
            is_empty = not any(tree.word(one).upos in _CONTENT - {"PRON"} for one in below - found)
            if child.deprel.split(":")[0] in _OF_GRAMMAR or child.deprel in _OF_GRAMMAR or is_empty:
                found |= below
    return frozenset(found)


def _frames_done(heard: Heard, known: FramedLexicon) -> Tuple[str, ...]:
    """Return the frames that a sentence commands; none if it is refused, or leaves more open than one element."""
    pending = heard.context.pending
    if isinstance(heard.outcome, Understood):
        best = [readings[0] for readings in heard.outcome.clauses]
    elif isinstance(heard.outcome, Question) and pending is not None and pending.clauses and not pending.is_about_words:
        best = [readings[0] for readings in pending.clauses]
    else:
        return ()
    frames = [known.frames[reading.unit.frame_name] for reading in best]
    if not all(frame.acts for frame in frames) or heard.sentence is None:
        return ()
    return tuple(frame.name for frame in frames)


def _is_open(heard: Heard) -> bool:
    """Whether something is still to be asked that a yes does not answer."""
    pending = heard.context.pending
    return pending is not None and bool(pending.elements)


def _choice(tree: DependencyTree, heard: Heard) -> Choice:
    text = tree.text.strip(" .,!?")
    made = heard.sentence.tree if heard.sentence is not None else tree
    return Choice(text[:1].lower() + text[1:], made)


def _with_other_verbs(tree: DependencyTree, heard: Heard, known: FramedLexicon, read: Read) -> Iterator[Candidate]:
    """Yield a sentence with other verbs in the place of one that is not known, or not in this sentence."""
    count = 0
    for gap in _gaps(tree, heard):
        done: Set[str] = set()
        for frame_name, verb, merit, reason in _verbs_for(tree, gap, known):
            if frame_name in done or (gap.said, frame_name) in known.declined:
                continue
            if count == _MOST_TRIED:
                return
            count += 1
            try:
                other = rephrased(tree, gap.positions - {gap.place}, verb.split(), gap.place)
            except NotATree:
                continue
            instead = read(other)
            frames = _frames_done(instead, known)
            evoked = [unit.frame_name for unit in known.units_of(verb) if unit.frame_name in frames]
            if evoked and evoked[0] not in done and (gap.said, evoked[0]) not in known.declined:
                done.update([frame_name, evoked[0]])
                lesson = Lesson(gap.said, verb, evoked[0], tree.text)
                yield Candidate(_choice(other, instead), frames, merit - _OPEN * _is_open(instead), reason, lesson)


def _gaps(tree: DependencyTree, heard: Heard) -> Iterator[_Gap]:
    """Yield the words for which a verb may stand: a verb with its object, and an unknown verb with its particles."""
    refused = [one.clause.verb for one in heard.clauses if one.refusal is not None]
    verbs = [word for word in tree.words if word.index in refused[:1]]
    verbs = verbs or [word for word in tree.words if not word.head and word.upos in VERBS]
    if not verbs:
        return
    verb = verbs[0]
    children = tree.children(verb.index)
    particles = frozenset(child.index for child in children if child.deprel == "compound:prt")
    for thing in children:
        if thing.deprel == "obj":
            near = (child.index for child in tree.children(thing.index) if child.deprel in _OF_IDIOMS)
            whole = {thing.index, *near} | particles
            if len(whole) <= _LONGEST_IDIOM and max(whole) - verb.index == len(whole):
                yield _gap(tree, verb, whole)
    if isinstance(heard.outcome, Refusal) and heard.outcome.code == "UNKNOWN_VERB":
        yield _gap(tree, verb, particles)


def _gap(tree: DependencyTree, verb: Word, others: Iterable[int]) -> _Gap:
    words = [verb.lemma.lower(), *(tree.word(index).said for index in sorted(others))]
    return _Gap(verb.index, frozenset([verb.index, *others]), " ".join(words))


_NO_EXAMPLE: Tuple[float, Optional[LexicalUnit], str] = (_UNKNOWN, None, "")


class _Verb(NamedTuple):
    frame_name: str
    verb: str
    merit: float
    reason: str


def _verbs_for(tree: DependencyTree, gap: _Gap, known: FramedLexicon) -> List[_Verb]:
    """Return verbs that may stand in a gap, those of the likeliest frames first.

    The merit of a frame is the mean of two: how like the words in the gap one of its verbs is, and how like the
    sentence one of its examples. The words alone do not tell what "make your way" is, nor do the things in the
    sentence tell what is done with them.
    """
    deeds, likeness = known.lexicon.deeds(known.frames), known.likeness
    of_verbs = likeness.of(gap.said, deeds.verb_texts) if likeness is not None else ()
    of_examples = likeness.of(tree.text.strip(" .!?"), deeds.texts) if likeness is not None else ()
    verbs: Dict[str, List[Tuple[float, str]]] = {}
    for (unit, verb), merit in zip(deeds.verbs, of_verbs or [_UNKNOWN] * len(deeds.verbs)):
        verbs.setdefault(unit.frame_name, []).append((merit, verb))
    examples: Dict[str, Tuple[float, Optional[LexicalUnit], str]] = {}
    for example, merit in zip(deeds.examples, of_examples):
        name = example.unit.frame_name
        if name not in examples or merit > examples[name][0]:
            examples[name] = (merit, example.unit, example.text)
    of_class = _class_of(gap.said, known)
    found: List[_Verb] = []
    for frame_name, listed in verbs.items():
        near = [verb for _, verb in listed if verb in of_class and (of_verbs or of_class[verb] == SYNONYM)]
        if not near and not of_verbs:
            continue
        likest = max(listed)
        of_example, example_unit, text = examples.get(frame_name, _NO_EXAMPLE)
        merit = (likest[0] + of_example) / 2 + _OF_CLASS * bool(near)
        if merit < _LEAST_MERIT + (_OF_KNOWN_WORDS if not near and len(gap.positions) == 1 else 0.0):
            continue
        reason = f'"{text}" is like it.' if text else ""
        if near:
            like = "the same as to" if of_class[near[0]] == SYNONYM else "a way to"
            reason = f"To {gap.said} is {like} {near[0]}."
        of_examples_unit = example_unit.verbs[:1] if example_unit is not None else ()
        tried = near[:1] or [likest[1], *of_examples_unit, listed[0][1]]
        found += [_Verb(frame_name, verb, merit, reason) for verb in dict.fromkeys(tried)]
    return sorted(found, key=lambda one: -one.merit)


def _class_of(verb: str, known: FramedLexicon) -> Dict[str, str]:
    try:
        net = shipped_wordnet(VERB)
    except NoWordNet:
        return {}
    return dict(known_verbs_near(net, verb, known.lexicon.verbs))
