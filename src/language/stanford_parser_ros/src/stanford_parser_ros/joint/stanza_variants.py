"""The joint model in Stanza's Pipeline: the variant of ``pos`` finds tags and heads, ``depparse`` keeps them."""

from pathlib import Path
from typing import Any, Dict

from stanford_parser_ros.joint.network import JointNetwork, alternatives_of
from stanford_parser_ros.stanza_attributes import ALTERNATIVES

NAME = "joint"


def register(folder: Path, *, threads: int = 1) -> Dict[str, str]:
    """Make the joint model known to Stanza under the name ``joint``; a later call replaces it.

    Args:
        folder: of the joint model
        threads: of ONNX Runtime
    Returns:
        the processors to hand to ``stanza.Pipeline``, beside those of a package
    Raises:
        ModelError: the model cannot be loaded
        ImportError: Stanza is not installed
    """
    from stanza.pipeline.processor import PROCESSOR_VARIANTS, ProcessorVariant

    network = JointNetwork(folder, threads=threads)

    class Tags(ProcessorVariant):  # type: ignore[misc]  # Stanza has no types
        """Fills tags, heads and relations."""

        OVERRIDE = True

        def __init__(self, _config: Any) -> None:
            pass

        def process(self, document: Any) -> Any:
            """Fill the sentences of a document."""
            for sentence in document.sentences:
                found = network.analyse([word.text for word in sentence.words])
                for number, word in enumerate(sentence.words):
                    word.upos, word.xpos = found.upos[number], found.xpos[number]
                    word.feats = None if found.feats[number] == "_" else found.feats[number]
                    word.head, word.deprel = found.heads[number], found.relations[number]
                setattr(sentence, ALTERNATIVES, alternatives_of(found))
            return document

    class Dependencies(ProcessorVariant):  # type: ignore[misc]
        """Makes Stanza's list of dependencies of the heads."""

        OVERRIDE = True

        def __init__(self, _config: Any) -> None:
            pass

        def process(self, document: Any) -> Any:
            """Complete the sentences of a document."""
            for sentence in document.sentences:
                sentence.build_dependencies()
            return document

    PROCESSOR_VARIANTS["pos"][NAME] = Tags
    PROCESSOR_VARIANTS["depparse"][NAME] = Dependencies
    return {"pos": NAME, "depparse": NAME}
