"""Runs a trainer with arithmetic that gives the same numbers on every processor: ``reproducible MODULE OPTION...``.

The environment of ``trainers`` fixes the kernels of the libraries. One thing remains: MKL takes square roots from an
approximation that differs between the makes of processors (every sixth one differs from the exact root in its last
bit), and each step of an optimiser needs them.
"""

import runpy
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import torch


def exact_square_root(numbers: "torch.Tensor") -> "torch.Tensor":
    """Return square roots as IEEE 754 rounds them; those of double precision are near enough to round to them."""
    import torch

    roots: torch.Tensor = torch.sqrt(numbers.double())
    return roots.to(numbers.dtype)


def main() -> None:
    """Run a module as a program whose optimisers take exact roots."""
    import torch

    torch.Tensor.sqrt = exact_square_root
    del sys.argv[0]
    runpy.run_module(sys.argv[0], run_name="__main__", alter_sys=True)


if __name__ == "__main__":
    main()
