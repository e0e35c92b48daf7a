"""The only place where one dependency tree is made of another; what comes of an edit is a tree, or nothing does."""

from dataclasses import dataclass, replace
from typing import AbstractSet, Callable, FrozenSet, List, Sequence, Tuple, Union

from utterance_passes.tree import DependencyTree, Word


class NotATree(ValueError):
    """An edit left words without a way to the one root."""


class TreeEdit:
    """Edits of one sentence that take effect together. Words are named by their position, from 1, which stays."""

    def __init__(self, tree: DependencyTree) -> None:
        self._tree = tree
        self._words = list(tree.words)
        self._brackets = tree.brackets

    def word(self, index: int) -> Word:
        """Return a word as it has become so far."""
        return self._words[index - 1]

    def rehang(self, index: int, head: int, deprel: str = "") -> None:
        """Hang a word on another one, or on the root (0), with a new relation or with the one it has."""
        word = self.word(index)
        self._words[index - 1] = replace(word, head=head, deprel=deprel or word.deprel)

    def rehang_children(self, index: int, head: int) -> None:
        """Hang on a word what hung on another one before the edit."""
        for child in self._tree.children(index):
            self._words[child.index - 1] = replace(self.word(child.index), head=head)

    def relabel(self, index: int, deprel: str) -> None:
        """Give a word another relation to its head."""
        self._words[index - 1] = replace(self.word(index), deprel=deprel)

    def retag(self, index: int, upos: str, xpos: str = "") -> None:
        """Give a word another part of speech; its Penn tag stays where none is given."""
        word = self.word(index)
        self._words[index - 1] = replace(word, upos=upos, xpos=xpos or word.xpos)

    def tag(self, index: int, upos: str, xpos: str, feats: str) -> None:
        """Give a word all tags of another one; its lemma becomes its form in lower case."""
        word = self.word(index)
        self._words[index - 1] = replace(word, lemma=word.form.lower(), upos=upos, xpos=xpos, feats=feats)

    def respell(self, index: int, form: str) -> None:
        """Put another word in the place of a word."""
        self._words[index - 1] = replace(self.word(index), form=form, lemma=form)

    def drop_brackets(self) -> None:
        """Forget the phrase tree of the parser: it is not that of the sentence any more."""
        self._brackets = ""

    def tree(self) -> DependencyTree:
        """Return the tree; the one that was there before where nothing changed.

        Raises:
            NotATree: the words hang together no more
        """
        words = tuple(self._words)
        if words == self._tree.words:
            return self._tree
        made = replace(self._tree, words=words, brackets=self._brackets)
        if not made.is_connected:
            raise NotATree(f'no tree comes of "{made.text}"')
        return made


def at_origins(tree: DependencyTree, text: str, origins: Sequence[int]) -> DependencyTree:
    """Return the tree of a rewritten text as that of the text as it was said.

    Args:
        tree: positions of characters are those of the rewritten text
        text: as it was said
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
    """Hang words on the root of the others, and what hung on them where they hung.

    Args:
        tree: the sentence
        positions: of the words; at least one word is left
        relation: of each of the words to the root
        is_verb: such a word becomes the root where the root was one of the words
    Raises:
        NotATree: no tree comes of it
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


def mark_times(tree: DependencyTree, times: Tuple[FrozenSet[int], ...]) -> DependencyTree:
    """Mark the phrases that say when."""
    return tree if times == tree.times else replace(tree, times=times)


def mark_sharing_a_verb(tree: DependencyTree, heads: FrozenSet[int]) -> DependencyTree:
    """Mark the heads of phrases that share the verb of the phrase before them, with those marked before."""
    marked = tree.sharing_a_verb | heads
    return tree if marked == tree.sharing_a_verb else replace(tree, sharing_a_verb=marked)


def mark_argument_clusters(tree: DependencyTree, clusters: Tuple[Tuple[int, FrozenSet[int]], ...]) -> DependencyTree:
    """Mark the groups of phrases that share a verb, with those marked before."""
    return replace(tree, clusters=tree.clusters + clusters) if clusters else tree


@dataclass(frozen=True)
class WordAround:
    """A word that is said around a command.

    Attributes:
        form: as said
        upos: universal part of speech
        xpos: part of speech of the Penn Treebank
        deprel: its relation to the root of the command
        start_character: where it begins in the text
        end_character: where it ends
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
    """Put words that are said around a command around its tree, in the order in which they stand in the text.

    Args:
        tree: of the command alone, which begins with its verb
        text: the whole utterance
        verb: the form that the verb has in it
        base: the base form of the verb
        around: each hangs on the root of the command, by its relation
    """
    first = tree.words[0]
    xpos = first.xpos if verb.lower() == base else "VBG"
    command = (replace(first, form=verb, lemma=base, xpos=xpos), *tree.words[1:])
    # The mark at the end of the command alone is none of the utterance.
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
    return DependencyTree(text=text, words=words)


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
    """Return one tree of the trees of an utterance's parts; each of the others hangs beside the first."""
    words: List[Word] = []
    first = 0
    for tree in trees:
        shift = len(words)
        for word in tree.words:
            is_beside = bool(first) and not word.head
            head = word.head + shift if word.head else first
            deprel = "parataxis" if is_beside else word.deprel
            words.append(replace(word, index=word.index + shift, head=head, deprel=deprel))
        first = first or next(word.index for word in words if word.head == 0)
    return DependencyTree(text=text, words=tuple(words))
