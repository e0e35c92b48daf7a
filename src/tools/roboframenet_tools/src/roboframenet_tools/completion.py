"""``rfn completion``: prints the bash function that completes ``rfn``."""

import argparse
import importlib

EXAMPLES = """examples:
  eval "$(rfn completion)"
  rfn completion > ~/.local/share/bash-completion/completions/rfn
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn completion``: none."""
    parser.epilog = EXAMPLES


def run(arguments: argparse.Namespace) -> int:
    """Print the completion; return the exit status."""
    print(script(), end="")
    return 0


def script() -> str:
    """Return the bash function, with the options that the subcommands declare."""
    from roboframenet_tools.cli import COMMANDS

    cases = []
    for name, module, _ in COMMANDS:
        parser = argparse.ArgumentParser()
        try:
            importlib.import_module(module).add_arguments(parser)
        except ImportError:  # a subcommand whose libraries are missing is completed by its name only
            continue
        options = [option for option in parser._option_string_actions if option.startswith("--")]
        cases.append(f'    {name}) COMPREPLY=($(compgen -W "{" ".join(options)}" -- "$word")) ;;')
    names = " ".join(name for name, _, _ in COMMANDS)
    return "\n".join(
        [
            "_rfn() {",
            '  local word="${COMP_WORDS[COMP_CWORD]}"',
            f'  if [ "$COMP_CWORD" -eq 1 ]; then COMPREPLY=($(compgen -W "{names}" -- "$word")); return; fi',
            '  [[ "$word" == -* ]] || return 0',
            '  case "${COMP_WORDS[1]}" in',
        ]
        + cases
        + ["  esac", "}", "complete -o default -F _rfn rfn", ""]
    )
