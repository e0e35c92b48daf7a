"""Reads what a person teaches in words, "when I say dismissed, go to the charger", and asks before it is kept.

The trees of "to freshen up means to open the window" and "when I say ..., ..." say which words are taught, and what
they mean. What they mean must be a deed that is understood, or several, which become a sequence in the frame graph.
Words that are understood already get no other meaning.
"""

from dataclasses import replace
from typing import Dict, FrozenSet, Iterable, Iterator, NamedTuple, Optional, Sequence, Tuple

from roboframenet_ros.spoken_text import join_with_and, join_with_or
from semantic_framer.asking.choices import question_of_choices
from semantic_framer.asking.settling import Now, in_words, resolve_and_confirm
from semantic_framer.asking.teaching_names import TaughtName, taught_name
from semantic_framer.clauses.readings import Heard, Read
from semantic_framer.filling.default_values import value_of_verb
from semantic_framer.queries.questions import idiom_readings
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.learned_units import Step, frame_of_sequence, text_of_idiom, text_of_sequence, words_of
from semantic_framer.values.dialogue import PRONOUNS, Context, Lesson, Pending, is_yes
from semantic_framer.values.outcome import LeftOverWords, Noted, Question, Refusal, Understood
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from typed_arguments import Source
from utterance_passes.engine.utterance_pass import Choice
from utterance_passes.trees.tree import DependencyTree, Word
from utterance_passes.trees.tree_edits import NotATree, rephrased
from word_classes import word_class

#: Name of the rule in the trace.
RULE = "teaching"
#: Code of the refusal to learn.
NOT_LEARNED = "NOT_LEARNED"
_SPEAKER = word_class("speaker_subjects") | word_class("speaker_objects")
_WHEN = "when"
_MEANS = "means"
_TO = "to"
_TO_FORGET = "forget"
_TO_TEACH = "teach"
_ABOUT = "about"
#: Words that can be taught hold one of these: "when I say so" and "when I say it" teach nothing.
_TAUGHT = frozenset(["NOUN", "PROPN", "VERB", "ADJ", "INTJ", "NUM", "X"])
_MARKS = frozenset(["mark", "aux", "case", "punct"])
#: Relations that a parser gives "to freshen up" before "means".
_SUBJECTS = frozenset(["csubj", "nsubj", "advcl", "obl"])
_DETERMINERS = word_class("determiners_and_possessives")
_NEGATIONS = word_class("negations")
#: So many deeds may be a sequence.
MOST_STEPS = 12


class _Taught(NamedTuple):
    """Words that are taught, and what they mean.

    Attributes:
        said: positions of the words
        words: the words, with the verb in its base form
        meaning: the sentence that says what they mean
        is_only_taught: whether the sentence says nothing if it teaches nothing
    """

    said: FrozenSet[int]
    words: str
    meaning: DependencyTree
    is_only_taught: bool


def taught_in_words(tree: DependencyTree, heard: Heard, context: Context, now: Now, read: Read) -> Heard:
    """Return what a sentence means, or the question whether to keep what it teaches.

    Args:
        tree: as the parser has it
        heard: what that means
        context: what the framer remembers of earlier utterances
        now: the circumstances of the utterance
        read: understands another tree, without a trace
    """
    if not _is_on(now) or heard.is_answer:
        return heard
    forgotten = _forgotten(tree, heard, context, now)
    if forgotten is not None:
        return forgotten if now.may_teach else _no_right(heard, context)
    name = taught_name(tree, now.known) if now.may_teach else None
    if name is not None:
        return _name_asked(name, heard, replace(context, pending=None), now)
    try:
        found = next(_taught(tree, now.known), None)
        if found is None:
            return heard
        if not now.may_teach:
            return _no_right(heard, context) if found.is_only_taught else heard
        known = read(rephrased(tree, frozenset(word.index for word in tree.words) - found.said))
    except NotATree:
        return heard
    context = replace(context, pending=None)
    meaning = found.meaning.text.strip(" .,!?")
    deeds = _deeds(read(found.meaning), now.known)
    refusal = ""
    if isinstance(known.outcome, Understood):
        refusal = f'I know "{found.words}" already, so I learn no other meaning of it.'
    elif not deeds:
        refusal = f'I do not understand "{meaning}" as things to do, so I do not learn "{found.words}".'
    if refusal:
        if not found.is_only_taught:
            return heard
        now.write(RULE, found.words, f"refused. {refusal}")
        return Heard(Refusal(NOT_LEARNED, refusal), context, heard.sentence)
    now.write(RULE, found.words, f"asked, whether it means {', then '.join(map(str, deeds))}")
    lesson = _lesson(found.words, meaning, deeds, tree, now.known)
    pending = Pending((), 0, (), now.expires_s, lessons=(lesson,))
    question = f'By "{found.words}", do you always mean "{_told(meaning, deeds)}"?{_so_far(known, now.known)}'
    return Heard(Question("CONFIRM", question), replace(context, pending=pending), heard.sentence)


def _name_asked(name: TaughtName, heard: Heard, context: Context, now: Now) -> Heard:
    """Return the question whether to keep what a sentence teaches of a thing or a place, or why it is not learned."""
    if name.refusal:
        now.write(RULE, name.lesson.said, f"refused. {name.refusal}")
        return Heard(Refusal(NOT_LEARNED, name.refusal), context, heard.sentence)
    now.write(RULE, name.lesson.said, f"asked, whether {name.lesson.told}")
    pending = Pending((), 0, (), now.expires_s, lessons=(name.lesson,))
    return Heard(Question("CONFIRM", name.question), replace(context, pending=pending), heard.sentence)


def _lesson(words: str, meaning: str, deeds: Sequence[Reading], tree: DependencyTree, known: FramedLexicon) -> Lesson:
    """Return what a yes teaches: an idiom of one deed, or of a sequence of deeds."""
    if len(deeds) == 1:
        values = {one.name: _said(deeds[0], one.name) for one in deeds[0].arguments}
        text = text_of_idiom(words, deeds[0].unit.frame_name, values)
        return Lesson(words, meaning, deeds[0].unit.frame_name, tree.text, text=text)
    steps = []
    for deed in deeds:
        # A default is that of the frame when it is done.
        said = [one.name for one in deed.arguments if one.source is not Source.DEFAULT]
        steps.append(Step(known.frames[deed.unit.frame_name], {name: _said(deed, name) for name in said}))
    name = frame_of_sequence(words, known.speaker)
    text = text_of_sequence(words, name, steps)
    return Lesson(words, _told(meaning, deeds), name, tree.text, text=text)


def _told(meaning: str, deeds: Sequence[Reading]) -> str:
    """Return what words mean, as it is told back: each deed of a sequence for itself."""
    if len(deeds) == 1:
        return meaning
    return ", then ".join(in_words(replace(deed, clause_text="")) for deed in deeds)


def _no_right(heard: Heard, context: Context) -> Heard:
    refusal = Refusal(NOT_LEARNED, "Only a person who speaks to me here may teach me words.")
    return Heard(refusal, replace(context, pending=None), heard.sentence)


def _so_far(heard: Heard, known: FramedLexicon) -> str:
    """Return what words mean that a person, perhaps another one, has taught already."""
    readings = idiom_readings(heard.sentence, known) if heard.sentence is not None else ()
    if not readings:
        return ""
    meanings = dict.fromkeys(f'"{known.taught.meanings.get(one.unit.path, str(one))}"' for one in readings)
    return f" So far it means {join_with_or(list(meanings))}."


def agreed(pending: Pending, said: Sentence, context: Context) -> Optional[Heard]:
    """Return what comes of the answer to the question whether to keep what was taught; None if it is no answer."""
    if not is_yes(said.tree.text):
        return None
    told = "; ".join(lesson.told or f'"{lesson.said}" means "{lesson.verb}"' for lesson in pending.taught)
    return Heard(Noted("DONE", f"All right: {told}."), context, said, lessons=pending.taught)


def known_by_heart(heard: Heard, context: Context, now: Now) -> Heard:
    """Return what a sentence means; one that means nothing else may be an idiom, which persons teach."""
    if isinstance(heard.outcome, Understood) or heard.is_answer or heard.sentence is None or not _is_on(now):
        return heard
    readings = idiom_readings(heard.sentence, now.known)
    if not readings:
        return heard
    text = heard.sentence.tree.text.strip(" .,!?")
    choices = _choices(readings, heard.sentence, now.known)
    if len(choices) > 1:
        now.write(RULE, text, "asked. Persons taught different meanings of it.")
        idioms = tuple(reading for reading, _ in choices)
        offered = tuple(choice for _, choice in choices)
        pending = Pending((), 0, (), now.expires_s, readings=offered, idioms=idioms)
        question = f'I was taught different meanings of "{text}". {question_of_choices(offered)}'
        return Heard(Question("AMBIGUOUS", question), replace(context, pending=pending), heard.sentence)
    now.write(RULE, text, f"is an idiom: {readings[0]}")
    outcome, after = resolve_and_confirm((readings,), heard.sentence, replace(context, pending=None), now)
    return Heard(outcome, after, heard.sentence)


def idiom_chosen(pending: Pending, choice: Choice, said: Sentence, context: Context, now: Now) -> Heard:
    """Return what comes of the choice among the meanings that persons taught."""
    idiom = pending.idioms[pending.readings.index(choice)]
    now.write("answer", said.tree.text, f'chooses "{choice.text}"')
    outcome, after = resolve_and_confirm(((idiom,),), said, context, now)
    return Heard(outcome, after, said, is_answer=True)


def _choices(
    readings: Sequence[Reading], sentence: Sentence, known: FramedLexicon
) -> Tuple[Tuple[Reading, Choice], ...]:
    """Return the different deeds that persons taught as the meaning of a sentence, each as it was told."""
    told: Dict[str, Reading] = {}
    for reading in readings:
        told.setdefault(known.taught.meanings.get(reading.unit.path, ""), reading)
    return tuple((reading, Choice(meaning, sentence.tree)) for meaning, reading in told.items() if meaning)


def _is_on(now: Now) -> bool:
    policy = now.policy
    return RULE not in now.known.without and policy.confirms and policy.left_over_words is LeftOverWords.ASK


def _taught(tree: DependencyTree, known: FramedLexicon) -> Iterator[_Taught]:
    """Yield what a sentence teaches."""
    for root in tree.words:
        if root.head:
            continue
        for clause in tree.children(root.index):
            if clause.deprel.startswith("advcl") and clause.index < root.index:
                yield from _by_saying(tree, clause, known)
        if root.said == _MEANS:
            yield from _by_meaning(tree, root)


def _by_saying(tree: DependencyTree, clause: Word, known: FramedLexicon) -> Iterator[_Taught]:
    """Yield what "when I say ..." in front of a command teaches."""
    children = tree.children(clause.index)
    marks = {one.index for one in children if one.said == _WHEN}
    speakers = {one.index for one in children if one.deprel == "nsubj" and one.said in _SPEAKER}
    if not marks or not speakers or known.speech_of(clause.lemma.lower()) is None:
        return
    inside = tree.subtree(clause.index)
    said = _without_punctuation(tree, inside - marks - speakers - {clause.index})
    if any(tree.word(index).upos in _TAUGHT for index in said):
        words = " ".join(tree.word(index).said for index in sorted(said))
        commas = {one.index for one in tree.words if one.upos == "PUNCT" and one.index < max(inside) + 2}
        yield _Taught(said, words, rephrased(tree, inside | commas), is_only_taught=False)


def _by_meaning(tree: DependencyTree, root: Word) -> Iterator[_Taught]:
    """Yield what "to ... means to ..." teaches."""
    children = tree.children(root.index)
    subjects = [one for one in children if one.index < root.index and one.deprel.split(":")[0] in _SUBJECTS]
    meanings = [one for one in children if one.index > root.index and one.deprel in ("xcomp", "ccomp")]
    if len(subjects) != 1 or len(meanings) != 1:
        return
    subject, meaning = subjects[0], meanings[0]
    marks = _marks(tree, subject)
    said = _without_punctuation(tree, tree.subtree(subject.index) - marks)
    if subject.upos != "VERB" and not any(tree.word(index).said == _TO for index in marks):
        return
    forms = {index: tree.word(index).said for index in said}
    words = " ".join(forms[index] if index != subject.index else subject.lemma.lower() for index in sorted(said))
    others = frozenset(word.index for word in tree.words) - _deeds_said(tree, root, meaning)
    yield _Taught(said, words, rephrased(tree, others, [meaning.lemma], meaning.index), is_only_taught=True)


def _deeds_said(tree: DependencyTree, root: Word, meaning: Word) -> FrozenSet[int]:
    """Return the positions of what is said of the deeds behind "means", without "to" before each of them."""
    behind = [one for one in tree.children(root.index) if one.index > meaning.index and one.upos != "PUNCT"]
    inside = tree.subtree(meaning.index).union(*(tree.subtree(one.index) for one in behind))
    joined = [one for one in tree.words if one.index in inside and one.deprel == "conj" and one.upos == "VERB"]
    marks = {one.index for verb in joined for one in tree.children(verb.index) if one.deprel == "mark"}
    return inside - _marks(tree, meaning) - marks


def _marks(tree: DependencyTree, verb: Word) -> FrozenSet[int]:
    return frozenset(one.index for one in tree.children(verb.index) if one.deprel in _MARKS)


def _without_punctuation(tree: DependencyTree, positions: FrozenSet[int]) -> FrozenSet[int]:
    return frozenset(index for index in positions if tree.word(index).upos != "PUNCT")


def _deeds(heard: Heard, known: FramedLexicon) -> Tuple[Reading, ...]:
    """Return the deeds that a sentence commands, one after the other, with nothing left open and nothing that was
    spoken of before; none for another sentence."""
    pending = heard.context.pending
    if isinstance(heard.outcome, Understood) and heard.outcome.plan is None:
        clauses = heard.outcome.clauses
    elif isinstance(heard.outcome, Question) and pending is not None and pending.plan is None and not pending.elements:
        clauses = pending.clauses
    else:
        return ()
    deeds = tuple(readings[0] for readings in clauses if readings)
    is_whole = len(deeds) == len(clauses) and 0 < len(deeds) <= MOST_STEPS
    return deeds if is_whole and all(_can_be_taught(one, known) for one in deeds) else ()


def _can_be_taught(reading: Reading, known: FramedLexicon) -> bool:
    is_plain = not reading.control.is_said and not reading.left_over and not reading.extra
    is_said = all(one.lemma.lower() not in PRONOUNS and not one.frames for one in reading.arguments)
    acts = reading.unit.frame_name in known.frames and known.frames[reading.unit.frame_name].acts
    return is_plain and is_said and acts


def _said(reading: Reading, name: str) -> str:
    """Return what an element is filled with in the words of a lexical unit: "on the shelf"."""
    argument = reading.argument(name)
    assert argument is not None
    said = f"{argument.relation.replace('_', ' ')} {argument.text}".strip()
    return said if value_of_verb(name, said).relation == argument.relation else argument.text


def _forgotten(tree: DependencyTree, heard: Heard, context: Context, now: Now) -> Optional[Heard]:
    """Return what comes of "forget what I taught you about ..."; None for another sentence.

    Words that are taught, "make your way", are only named here, and a parser hangs them on anything.
    """
    said = [word for word in tree.words if word.upos != "PUNCT"]
    places = {one.lemma.lower(): place for place, one in reversed(tuple(enumerate(said)))}
    order = [places.get(lemma, -1) for lemma in (_TO_FORGET, _TO_TEACH, _ABOUT)]
    is_asked = -1 < order[0] < order[1] < order[2] < len(said) - 1 and (order[0] == 0 or not said[order[0]].head)
    if not is_asked or any(one.said in _NEGATIONS for one in said[: order[0]]):
        return None
    asked = [one.index for one in said[order[2] + 1 :]]
    return _forgetting(asked, tree, heard, replace(context, pending=None), now)


def _forgetting(positions: Sequence[int], tree: DependencyTree, heard: Heard, context: Context, now: Now) -> Heard:
    words = [tree.word(index) for index in positions]
    asked = [_bare(one.form for one in words), _bare(one.lemma for one in words)]
    learned = (unit for unit in now.known.lexicon.units if unit.is_learned)
    taught = now.known.taught
    words_taught = (*(said for unit in learned for said in words_of(unit)), *taught.kinds, *taught.places)
    bare = {said: _bare(said.split()) for said in words_taught}
    # "Moseying over" is about "mosey", too; the longest is meant.
    matching = {said: len(words) for said, words in bare.items() if any(one[: len(words)] == words for one in asked)}
    found = sorted(said for said, length in matching.items() if length == max(matching.values()))
    if not found:
        refusal = Refusal(NOT_LEARNED, f'Nobody taught me anything about "{tree.text_of(positions)}".')
        return Heard(refusal, context, heard.sentence)
    told = join_with_and([f'"{said}"' for said in found])
    now.write(RULE, tree.text, f"forgets {told}")
    lessons = tuple(Lesson(said, "", "", tree.text, is_forgotten=True) for said in found)
    return Heard(Noted("DONE", f"I have forgotten {told}."), context, heard.sentence, lessons=lessons)


def _bare(words: Iterable[str]) -> Tuple[str, ...]:
    """Return words without possessives and articles: "your way" is "my way"."""
    return tuple(word.lower() for word in words if word.lower() not in _DETERMINERS)
