"""Motions as functions of PyTorch, for `backward` as for `torch.func`: jvp, vjp, vmap."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import torch

from lagdsl.interfaces.api.functions.motion_function import MotionFunction


def in_torch(function: MotionFunction) -> Callable[[Any], Any]:
    """y(x) of PyTorch, (..., free) to (..., rows, of), in double precision."""

    class Jacobian(torch.autograd.Function):  # type: ignore[misc]
        """(..., rows, of, free), which has no derivative of its own."""

        @staticmethod
        def forward(x: Any) -> Any:
            return torch.from_numpy(function.differentiate(x.detach().cpu().numpy())[1]).to(x.device)

        @staticmethod
        def setup_context(ctx: Any, inputs: tuple[Any], output: Any) -> None:
            ctx.mark_non_differentiable(output)

        @staticmethod
        def backward(ctx: Any, *gradients: Any) -> Any:
            raise NotImplementedError("motions have first derivatives only")

        @staticmethod
        def vmap(info: Any, dims: tuple[int | None], x: Any) -> tuple[Any, int]:
            return Jacobian.apply(_in_front(info, dims, x)), 0

    class Motion(torch.autograd.Function):  # type: ignore[misc]
        """The columns. Products are written out: the batches of `gradcheck` know no `einsum`."""

        @staticmethod
        def forward(x: Any) -> Any:
            return torch.from_numpy(function(x.detach().cpu().numpy())).to(x.device)

        @staticmethod
        def setup_context(ctx: Any, inputs: tuple[Any], output: Any) -> None:
            ctx.save_for_backward(*inputs)
            ctx.save_for_forward(*inputs)

        @staticmethod
        def backward(ctx: Any, *gradients: Any) -> Any:
            return (Jacobian.apply(*ctx.saved_tensors) * gradients[0].unsqueeze(-1)).sum((-3, -2))

        @staticmethod
        def jvp(ctx: Any, *tangents: Any) -> Any:
            return (Jacobian.apply(*ctx.saved_tensors) * tangents[0].unsqueeze(-2).unsqueeze(-2)).sum(-1)

        @staticmethod
        def vmap(info: Any, dims: tuple[int | None], x: Any) -> tuple[Any, int]:
            return Motion.apply(_in_front(info, dims, x)), 0

    def called(x: Any) -> Any:
        """The columns at the times of the rows, (..., rows, of), for the values x (..., free) of what is free."""
        return Motion.apply(torch.as_tensor(x, dtype=torch.float64))

    return called


def _in_front(info: Any, dims: tuple[int | None], x: Any) -> Any:
    """With the mapped axis as the first."""
    return x.expand(info.batch_size, *x.shape) if dims[0] is None else x.movedim(dims[0], 0)
