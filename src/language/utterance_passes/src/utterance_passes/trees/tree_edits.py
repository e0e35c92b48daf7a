"""Derives one dependency tree from another; no other module does. An edit either gives a tree or fails."""

from dataclasses import dataclass, replace
from typing import AbstractSet, Callable, FrozenSet, List, Optional, Sequence, Tuple, Union

from utterance_passes.trees.tree import ASIDE, CLOSE_MARKS, Alternative, DependencyTree, Word


class NotATree(ValueError):
    """After an edit, the words no longer form a tree with one root."""


class TreeEdit:
    """Edits of one sentence that take effect together. The position of a word, from 1, names it and never changes."""

    def __init__(self, tree: DependencyTree) -> None:
        self._tree = tree
        self._words = list(tree.words)
        self._brackets = tree.brackets

    def word(self, index: int) -> Word:
        """Return a word with the edits so far."""
        return self._words[index - 1]

    def rehang(self, index: int, head: int, deprel: str = "") -> None:
        """Attach a word to another word, or make it the root (head 0); an empty relation keeps the old one."""
        word = self.word(index)
        self._words[index - 1] = replace(word, head=head, deprel=deprel or word.deprel)

    def rehang_children(self, index: int, head: int) -> None:
        """Attach the children that a word had before the edit to another word."""
        for child in self._tree.children(index):
            self._words[child.index - 1] = replace(self.word(child.index), head=head)

    def relabel(self, index: int, deprel: str) -> None:
        """Give a word another relation to its head."""
        self._words[index - 1] = replace(self.word(index), deprel=deprel)

    def retag(self, index: int, upos: str, xpos: str = "") -> None:
        """Give a word another part of speech; an empty Penn tag keeps the old one."""
        word = self.word(index)
        self._words[index - 1] = replace(word, upos=upos, xpos=xpos or word.xpos)

    def make_preposition(self, index: int, noun: int) -> None:
        """Make a word the preposition of a noun."""
        self.retag(index, "ADP", "IN")
        self.rehang(index, noun, "case")

    def tag(self, index: int, upos: str, xpos: str, feats: str) -> None:
        """Replace all tags of a word; its lemma becomes its form in lower case."""
        word = self.word(index)
        self._words[index - 1] = replace(word, lemma=word.form.lower(), upos=upos, xpos=xpos, feats=feats)

    def respell(self, index: int, form: str, lemma: str = "") -> None:
        """Replace the form and the lemma of a word; an empty lemma is the form."""
        self._words[index - 1] = replace(self.word(index), form=form, lemma=lemma or form)

    def drop_brackets(self) -> None:
        """Drop the phrase tree of the parser: it no longer fits the sentence."""
        self._brackets = ""

    def tree(self) -> DependencyTree:
        """Return the edited tree; the same object as before if no word changed.

        Raises:
            NotATree: the words no longer form a tree
        """
        words = tuple(self._words)
        if words == self._tree.words:
            return self._tree
        made = replace(self._tree, words=words, brackets=self._brackets)
        if not made.is_connected:
            raise NotATree(f'no tree comes of "{made.text}"')
        return made


def at_origins(tree: DependencyTree, text: str, origins: Sequence[int]) -> DependencyTree:
    """Return the tree of a rewritten text as a tree of the text as it was said.

    Args:
        tree: tree with positions of characters in the rewritten text
        text: the text as it was said
        origins: for each character of the rewritten text, and one past its end, the position in the text
    """
    return replace(
        tree,
        text=text,
        words=tuple(
            replace(
                word,
                start_character=origins[word.start_character],
                end_character=origins[min(word.end_character, len(origins) - 1)],
            )
            for word in tree.words
        ),
    )


def set_aside(
    tree: DependencyTree, positions: AbstractSet[int], relation: str, is_verb: Callable[[Word], bool]
) -> DependencyTree:
    """Attach words to the root of the other words, and their children to the heads that they had.

    Args:
        tree: the sentence
        positions: positions of the words; at least one word must stay
        relation: relation of each of the words to the root
        is_verb: if the root is one of the words, such a word becomes the new root if possible
    Raises:
        NotATree: the result is not a tree
    """
    heads = {}
    for word in tree.words:
        head = word.head
        while head in positions:
            head = tree.word(head).head
        heads[word.index] = head
    tops = [word for word in tree.open_words if word.index not in positions and heads[word.index] == 0]
    spoken = [word for word in tops if word.upos != "PUNCT"]
    root = ([word for word in spoken if is_verb(word)] or spoken or tops)[0]
    edit = TreeEdit(tree)
    for word in tree.words:
        if word.index == root.index:
            edit.rehang(word.index, 0, "root")
        elif word.index in positions:
            edit.rehang(word.index, root.index, relation)
        elif heads[word.index] == 0:
            is_clause = word.upos == "VERB" and word.index > root.index
            edit.rehang(word.index, root.index, "parataxis" if is_clause else word.deprel)
        else:
            edit.rehang(word.index, heads[word.index])
    return edit.tree()


def rephrased(
    tree: DependencyTree, left_out: AbstractSet[int], verb: Sequence[str] = (), place: int = 0
) -> DependencyTree:
    """Return the tree of a sentence that is said without some words, and with another verb in the place of one.

    Args:
        tree: the sentence
        left_out: positions of the words that are left out; what hangs on them hangs on their governors
        verb: words of the other verb; none if the verbs stay
        place: position of the word that the verb takes the place of
    Raises:
        NotATree: nothing stays, or the result is not a tree
    """
    kept = [word for word in tree.words if word.index not in left_out]
    if not kept:
        raise NotATree(f'nothing of "{tree.text}" stays')
    new, count = {0: 0}, 0
    for word in kept:
        new[word.index] = count = count + 1
        count += len(verb) - 1 if verb and word.index == place else 0

    def above(word: Word) -> int:
        head = word.head
        while head not in new:
            head = tree.word(head).head
        return head

    tops = [word for word in kept if not above(word)]
    root = ([word for word in tops if word.upos == "VERB"] or [w for w in tops if w.upos != "PUNCT"] or tops)[0]
    words: List[Word] = []
    text = ""
    for old in kept:
        head, relation = above(old), old.deprel
        if old is root:
            head, relation = 0, "root"
        elif not head:
            head, relation = root.index, "punct" if old.upos == "PUNCT" else "parataxis"
        elif head != old.head and head == place and relation == "nmod":
            relation = "obl"  # "Have a look at the shelf" is "look at the shelf".
        is_verb = bool(verb) and old.index == place
        for number, form in enumerate(verb if is_verb else [old.form]):
            text += " " if text and (is_verb or not form.startswith(CLOSE_MARKS)) else ""
            start, text = len(text), text + form
            if number:
                words.append(_unsaid(len(words) + 1, form, "ADP", "RP", new[place], "compound:prt", start))
            elif is_verb:
                words.append(_unsaid(new[place], form, "VERB", "VB", new[head], relation, start))
            else:
                moved = replace(old, index=new[old.index], head=new[head], deprel=relation)
                words.append(replace(moved, start_character=start, end_character=len(text)))
    made = DependencyTree(text, tuple(words))
    if not made.is_connected:
        raise NotATree(f'no tree comes of "{text}"')
    return made


def mark_times(tree: DependencyTree, times: Tuple[FrozenSet[int], ...]) -> DependencyTree:
    """Mark the phrases that say when."""
    return tree if times == tree.times else replace(tree, times=times)


def mark_sharing_a_verb(tree: DependencyTree, heads: FrozenSet[int]) -> DependencyTree:
    """Add marks for the heads of phrases that share the verb of the phrase before them."""
    marked = tree.sharing_a_verb | heads
    return tree if marked == tree.sharing_a_verb else replace(tree, sharing_a_verb=marked)


def mark_argument_clusters(tree: DependencyTree, clusters: Tuple[Tuple[int, FrozenSet[int]], ...]) -> DependencyTree:
    """Add marks for groups of phrases that share a verb."""
    return replace(tree, clusters=tree.clusters + clusters) if clusters else tree


@dataclass(frozen=True)
class WordAround:
    """A word beside a command.

    Attributes:
        form: the word as it was said
        upos: universal part of speech
        xpos: Penn Treebank tag
        deprel: its relation to the root of the command
        start_character: position of its first character in the text, from 0
        end_character: position after its last character
    """

    form: str
    upos: str
    xpos: str
    deprel: str
    start_character: int
    end_character: int


def with_words_around(
    tree: DependencyTree, text: str, verb: str, base: str, around: Sequence[WordAround]
) -> DependencyTree:
    """Add the words around a command to its tree, in the order of the text.

    Args:
        tree: tree of the command alone, which begins with its verb
        text: the whole utterance
        verb: the form of the verb in the utterance
        base: the base form of the verb
        around: words to attach to the root of the command, with their relations
    """
    first = tree.words[0]
    xpos = first.xpos if verb.lower() == base else "VBG"
    command = (replace(first, form=verb, lemma=base, xpos=xpos), *tree.words[1:])
    # The utterance does not contain the mark at the end of the command alone.
    if around and command[-1].upos == "PUNCT" and around[-1].start_character >= command[-1].start_character:
        command = command[:-1]
    ordered: List[Union[Word, WordAround]] = sorted([*command, *around], key=lambda word: word.start_character)
    moved = {word.index: position for position, word in enumerate(ordered, start=1) if isinstance(word, Word)}
    root = next(moved[word.index] for word in command if word.head == 0)
    words = tuple(
        replace(word, index=position, head=moved.get(word.head, 0))
        if isinstance(word, Word)
        else _hanging_on(root, position, word)
        for position, word in enumerate(ordered, start=1)
    )
    alternatives = tuple(
        one._replace(word=moved[one.word], head=moved.get(one.head, 0))
        for one in tree.alternatives
        if one.word in moved and (one.head in moved or not one.head)
    )
    return DependencyTree(text=text, words=words, alternatives=alternatives)


def _hanging_on(root: int, position: int, word: WordAround) -> Word:
    return Word(
        index=position,
        form=word.form,
        lemma=word.form.lower(),
        upos=word.upos,
        xpos=word.xpos,
        feats="",
        head=root,
        deprel=word.deprel,
        start_character=word.start_character,
        end_character=word.end_character,
    )


def joined(text: str, trees: Sequence[DependencyTree]) -> DependencyTree:
    """Join the trees of the parts of an utterance; the other parts become parataxis of the first."""
    words: List[Word] = []
    alternatives: List[Alternative] = []
    first = 0
    for tree in trees:
        shift = len(words)
        alternatives += [
            one._replace(word=one.word + shift, head=one.head + shift if one.head else 0) for one in tree.alternatives
        ]
        for word in tree.words:
            is_beside = bool(first) and not word.head
            head = word.head + shift if word.head else first
            deprel = "parataxis" if is_beside else word.deprel
            words.append(replace(word, index=word.index + shift, head=head, deprel=deprel))
        first = first or next(word.index for word in words if word.head == 0)
    return DependencyTree(text=text, words=tuple(words), alternatives=tuple(alternatives))


def said_after(tree: DependencyTree, answer: DependencyTree) -> DependencyTree:
    """Return the tree of two utterances, the second of which goes on with the first: "is it open?", "if so, close it".

    Args:
        tree: of the first
        answer: of the second
    """
    text, first = f"{tree.text} {answer.text}", len(tree.words)
    moved = at_origins(answer, text, range(len(tree.text) + 1, len(text) + 1))
    times = (*tree.times, *(frozenset(index + first for index in time) for time in answer.times))
    return mark_times(joined(text, (tree, moved)), times)


def lasting(tree: DependencyTree, duration: DependencyTree) -> DependencyTree:
    """Return the tree of a command with how long it goes on: "follow Anna" and "until she is in the kitchen".

    Args:
        tree: of the command
        duration: of what is said of its end
    """
    whole = said_after(tree, duration)
    edit = TreeEdit(whole)
    first = len(tree.words)
    if tree.words[-1].upos == "PUNCT":
        edit.respell(first, ",")
    edit.respell(first + 1, whole.word(first + 1).said)
    for word in whole.words[first:]:
        if word.deprel == "parataxis" and word.head <= first:
            is_clause = any(child.deprel == "mark" for child in whole.children(word.index))
            edit.relabel(word.index, "advcl" if is_clause else "obl")
    return edit.tree()


def _inside_sentence(word: Word) -> str:
    """Return the form of a word that no longer begins its sentence: "turn *the* lights off" for "*The* lights off"."""
    is_common = word.index == 1 and word.upos != "PROPN" and word.form.istitle() and word.form != "I"
    return word.said if is_common else word.form


def behind_verb(
    tree: DependencyTree,
    verb: Sequence[str],
    kept: AbstractSet[int],
    last_word: str = "",
    *,
    objects: Optional[Tuple[int, int]] = None,
) -> DependencyTree:
    """Put the words of a fragment behind a verb that was not said: "ten feet" becomes "move ten feet".

    Args:
        tree: the fragment
        verb: words of the verb; they get the first positions
        kept: positions of the words of the fragment that count; the others become asides
        last_word: a noun that the fragment leaves out, after its last kept word; empty for none
        objects: the heads of a person and a thing that are both objects of the verb: "Bob a tea"; None for other words
    """
    shift = len(verb)
    said = " ".join(verb)
    words = [_unsaid(1, verb[0], "VERB", "VB", 0, "root", 0)]
    for index, particle in enumerate(verb[1:], start=2):
        words.append(_unsaid(index, particle, "ADP", "RP", 1, "compound:prt", said.index(particle)))
    offset = len(said) + 1
    for word in tree.words:
        head = word.head
        while head and head not in kept:
            head = tree.word(head).head
        is_top = word.index in kept and not head
        deprel = word.deprel
        if word.index not in kept:
            head, deprel = 0, "punct" if word.upos == "PUNCT" else ASIDE
        elif objects is not None and word.index in objects:
            head, deprel = 0, "iobj" if word.index == objects[0] else "obj"
        elif deprel == "compound:prt":
            head = 0  # "The lamp on" is "turn the lamp on".
        elif is_top:
            deprel = _relation_of_top(tree, word, kept)
        words.append(
            replace(
                word,
                index=word.index + shift,
                form=_inside_sentence(word),
                head=head + shift if head else 1,
                deprel=deprel,
                start_character=word.start_character + offset,
                end_character=word.end_character + offset,
            )
        )
    text = f"{said} {tree.text}"
    if last_word:
        end = tree.word(max(kept)).end_character + offset
        text = f"{text[:end]} {last_word}"
        words = [word for word in words if word.index <= max(kept) + shift]
        words.append(_unsaid(len(words) + 1, last_word, "NOUN", "NNS", 1, "obj", end + 1))
    return DependencyTree(text=text, words=tuple(words))


def _relation_of_top(tree: DependencyTree, word: Word, kept: AbstractSet[int]) -> str:
    children = [child for child in tree.children(word.index) if child.index in kept]
    if any(child.deprel == "case" for child in children):
        return "obl"
    return "obj" if word.upos in ("NOUN", "PROPN", "PRON", "NUM", "SYM", "X") else "advmod"


def _unsaid(index: int, form: str, upos: str, xpos: str, head: int, deprel: str, start: int) -> Word:
    return Word(index, form, form, upos, xpos, "", head, deprel, start, start + len(form))


def continued(tree: DependencyTree, link: int, answer: DependencyTree) -> DependencyTree:
    """Return the tree of an unfinished sentence with the words that a person says behind it: "wait until" and "noon".

    Args:
        tree: of the sentence
        link: position of the last word that joins, behind which something is missing
        answer: what was said then; a link at its front that was said already is left out
    """
    first = list(tree.words[:link])
    said = list(answer.words)
    if len(said) > 1 and said[0].said == tree.word(link).said:
        said.pop(0)
    kept = {word.index: link + place for place, word in enumerate(said, start=1)}
    head = next((kept[word.index] for word in said if word.head not in kept), link + 1)
    root = next(word.index for word in first if word.head == 0 or word.head > link)
    shift = len(tree.text) + 1
    words = [
        replace(word, head=0 if word.index == root else word.head if 0 < word.head <= link else root) for word in first
    ]
    if link != root:
        words[link - 1] = replace(words[link - 1], upos="SCONJ", xpos="IN", head=head, deprel="mark")
    for word in said:
        place = kept[word.index]
        is_head = place == head
        words.append(
            replace(
                word,
                index=place,
                head=root if is_head else kept.get(word.head, head),
                deprel="advcl" if is_head else word.deprel,
                start_character=word.start_character + shift,
                end_character=word.end_character + shift,
            )
        )
    times = tuple(time for time in tree.times if max(time) <= link)
    return DependencyTree(f"{tree.text} {answer.text}", tuple(words), times=times)
