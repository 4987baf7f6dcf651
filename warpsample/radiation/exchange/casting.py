"""Casts the rays of faces, block by block on worker threads, and counts what they meet."""

import threading
from collections import deque
from collections.abc import Callable
from contextvars import Context
from dataclasses import dataclass
from functools import partial

import numpy as np
import warp as wp

from warpsample.host.arrays import cpu
from warpsample.host.engine import run
from warpsample.host.interrupts import uninterrupted
from warpsample.host.progress import begin
from warpsample.host.sharing import share
from warpsample.mesh.mesh import Mesh
from warpsample.radiation.exchange.coincident import coincident_kernel
from warpsample.radiation.exchange.face_kernel import face_kernel
from warpsample.radiation.exchange.face_rays import BACK, FaceRaysArgs, step_of
from warpsample.radiation.exchange.hits_to_matrix import Block, Collector, Counts, block_of
from warpsample.radiation.exchange.open_faces import open_kernel
from warpsample.sequences.hashing import seed_for
from warpsample.tracing.queries import AcceleratorArgs
from warpsample.tracing.rays import RAY_WORK
from warpsample.tracing.scene import Scene, coarseness_of, scene_of
from warpsample.tracing.tracers import WIDE

_BLOCK = 256  # faces whose rays are kept at a time, as long as they are fewer than
_BLOCK_RAYS = 1 << 22


class InOrder:
    """Blocks that threads put in any order, and that a function takes one at a time in the order of their numbers."""

    def __init__(self, take: Callable[[Block], None]) -> None:
        self._take = take
        self._next = 0
        self._early: dict[int, Block] = {}
        self._taking = threading.Lock()

    def put(self, number: int, block: Block) -> None:
        """Add a block, and let the function take all blocks that are next; numbers count from 0."""
        with self._taking:
            self._early[number] = block
            while self._next in self._early:
                self._take(self._early.pop(self._next))
                self._next += 1


@dataclass(frozen=True)
class Casting:
    """The checked arguments by which rays are cast."""

    mesh: Mesh
    per_replicate: int
    replicates: int
    seed: int
    up: tuple[float, float, float] | None
    first_face: int
    skip: bool
    workers: int

    @property
    def rays(self) -> int:
        """The number of rays of each face."""
        return self.per_replicate * self.replicates

    def upward(self) -> np.ndarray | None:
        """(F,) float64, the share of each face's hemisphere that is above the horizon; None without one."""
        if self.up is None:
            return None
        return np.clip(0.5 + 0.5 * (self.mesh.face_normals.astype(np.float64) @ self.up), 0.0, 1.0)

    def counts(self, rows: np.ndarray, surfaces: np.ndarray | None) -> tuple[Counts, np.ndarray]:
        """What the rays of some faces meet, and which of all faces cast any."""
        scene = scene_of(self.mesh, through=True)
        tree = WIDE.accelerator(scene, cpu(), self.workers)
        rays, normals = self._rays(scene), self.mesh.face_normals
        rays.normals = normals.ctypes.data
        collector = Collector(len(self.mesh.faces), self.replicates, scene.has_glass)
        if self.skip and len(rows):
            opens = self._opens(rays, tree, rows)
            if scene.has_glass:
                opens &= self._opens(rays, rays.glass.tree, rows)
            collector.all_open(rows[opens], self.per_replicate)
            rows = rows[~opens]
        done = begin(len(rows), RAY_WORK * self.rays * len(rows))

        def take(block: Block) -> None:
            collector.take(block)
            if done:
                done(len(block.rows))

        self._cast(rays, tree, rows=rows, surfaces=surfaces, blocks=InOrder(take))
        cast = np.zeros(len(self.mesh.faces), np.bool_)
        cast[rows] = True
        return collector.counts(), cast

    def _opens(self, rays: FaceRaysArgs, tree: AcceleratorArgs, rows: np.ndarray) -> np.ndarray:
        """(B,) bool, the faces that nothing in a tree stands above."""
        opens = np.zeros(len(rows), np.uint8)
        rays.rows = rows.ctypes.data
        inputs = [rays, tree, opens.ctypes.data]
        run(open_kernel(), len(rows), inputs, cpu(), workers=self.workers, work=RAY_WORK * len(rows))
        return opens == 1

    def _cast(
        self,
        rays: FaceRaysArgs,
        tree: AcceleratorArgs,
        *,
        rows: np.ndarray,
        surfaces: np.ndarray | None,
        blocks: InOrder,
    ) -> None:
        """Casts and counts the rays of rows in blocks, each by one thread, so that none waits for the others."""
        size = max(1, min(_BLOCK, _BLOCK_RAYS // self.rays, -(-len(rows) // (4 * self.workers))))
        firsts = iter(range(0, len(rows), size))

        def part() -> None:
            for first in firsts:
                blocks.put(first // size, self._block(rays, tree, rows[first : first + size], surfaces))

        if size >= len(rows):
            part()
        else:  # away from the caller's context, where a block would show a bar of its own in place of that of all
            parts, stop = [partial(Context().run, part) for _ in range(self.workers)], partial(deque, firsts, maxlen=0)
            uninterrupted(partial(share, parts, stop), stop)

    def _rays(self, scene: Scene) -> FaceRaysArgs:
        """The rays of a scene; it holds addresses of the scene's arrays, which live as long as the mesh."""
        return FaceRaysArgs(
            vertices=scene.vertices.ctypes.data,
            triangles=scene.faces.ctypes.data,
            seed=seed_for("faces", self.seed),
            first_face=self.first_face,
            replicates=self.replicates,
            per_replicate=self.per_replicate,
            step=step_of(self.per_replicate),
            extent=wp.vec3(*scene.extent),
            coarseness=coarseness_of(scene, True),
            up=wp.vec3(*(self.up or (0.0, 0.0, 0.0))),
            **({"glass": scene.glass(self.workers)} if scene.has_glass else {}),
        )

    def _block(self, of_all: FaceRaysArgs, tree: AcceleratorArgs, rows: np.ndarray, surfaces: np.ndarray | None) -> Block:
        """Casts the rays of some faces, and counts what they meet."""
        codes = np.empty((len(rows), self.replicates, self.per_replicate), np.int32)
        rays = FaceRaysArgs.from_buffer_copy(of_all)
        rays.rows, rays.codes = rows.ctypes.data, codes.ctypes.data
        weights = np.empty(codes.shape, np.float32) if of_all.glass.transmittance else None
        rays.weights = 0 if weights is None else weights.ctypes.data
        run(face_kernel(weights is not None), len(rows), [rays, tree], cpu(), workers=1, work=RAY_WORK * codes.size)
        if codes.min() <= BACK:
            backs = np.flatnonzero(codes <= BACK)
            run(
                coincident_kernel(),
                len(backs),
                [rays, tree, backs.ctypes.data],
                cpu(),
                workers=1,
                work=RAY_WORK * len(backs),
            )
        return block_of(rows, codes, surfaces, weights)
