"""Ray casting for view factors: rays start on each face, in blocks on worker threads, and their hits are counted."""

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
from warpsample.host.locks import multiply
from warpsample.host.progress import begin
from warpsample.host.sharing import share
from warpsample.mesh.mesh import Mesh
from warpsample.radiation.exchange.coincident import coincident_kernel
from warpsample.radiation.exchange.face_kernel import face_kernel
from warpsample.radiation.exchange.face_rays import BACK, FaceRaysArgs, step_of
from warpsample.radiation.exchange.hits_to_matrix import Block, Collector, HitCounts, block_of
from warpsample.radiation.exchange.open_faces import open_kernel
from warpsample.sequences.hashing import seed_for
from warpsample.tracing.queries import AcceleratorArgs
from warpsample.tracing.rays import RAY_WORK
from warpsample.tracing.scene import Scene, coarseness_of, scene_of
from warpsample.tracing.tracers import WIDE

_BLOCK = 256  # most faces per block
_BLOCK_RAYS = 1 << 22  # most rays per block of several faces


class InOrder:
    """Queue that accepts numbered blocks of work in any order and passes blocks on in ascending order.

    Threads put blocks in; a function receives them.
    """

    def __init__(self, take: Callable[[Block], None]) -> None:
        """Create the queue; `take` is called with each block, in ascending order."""
        self._take = take
        self._next = 0
        self._early: dict[int, Block] = {}
        self._lock = threading.Lock()

    def add_block(self, number: int, block: Block) -> None:
        """Accept block number `number`, and pass on all blocks whose predecessors have arrived; numbers start at 0."""
        with self._lock:
            self._early[number] = block
            while self._next in self._early:
                self._take(self._early.pop(self._next))
                self._next += 1


@dataclass(frozen=True)
class Casting:
    """Checked arguments of `view_factors` that concern rays: mesh, number of rays, seed and threads."""

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
        """Number of rays per face."""
        return self.per_replicate * self.replicates

    def upward(self) -> np.ndarray | None:
        """Share of each face's hemisphere above the horizon, (F,) float64; None if `up` is None."""
        if self.up is None:
            return None
        return np.clip(0.5 + 0.5 * multiply(self.mesh.face_normals.astype(np.float64), self.up), 0.0, 1.0)

    def counts(self, rows: np.ndarray, surfaces: np.ndarray | None) -> tuple[HitCounts, np.ndarray]:
        """Cast rays from the faces with the given numbers; return counts of the surfaces hit, and a mask of casting faces.

        surfaces: (F,) int32, column of each face; None for one column per face.
        """
        scene = scene_of(self.mesh, through=True)
        tree = WIDE.accelerator(scene, cpu(), self.workers)
        rays, normals = self._build_rays(scene), self.mesh.face_normals
        rays.normals = normals.ctypes.data
        collector = Collector(len(self.mesh.faces), self.replicates, scene.has_glass)
        if self.skip and len(rows):
            opens = self._find_open_faces(rays, [tree, rays.glass.tree] if scene.has_glass else [tree], rows)
            collector.all_open(rows[opens], self.per_replicate)
            rows = rows[~opens]
        done = begin(len(rows), RAY_WORK * self.rays * len(rows))

        def take(block: Block) -> None:
            collector.take(block)
            if done:
                done(len(block.rows))

        self._cast_rows(rays, tree, rows=rows, surfaces=surfaces, blocks=InOrder(take))
        cast = np.zeros(len(self.mesh.faces), np.bool_)
        cast[rows] = True
        return collector.counts(), cast

    def _find_open_faces(self, rays: FaceRaysArgs, trees: list[AcceleratorArgs], rows: np.ndarray) -> np.ndarray:
        """Return a mask of the given faces that have no geometry above their plane, so that their rays hit nothing."""
        opens = np.zeros((len(trees), len(rows)), np.uint8)
        rays.rows = rows.ctypes.data
        for tree, found in zip(trees, opens, strict=True):
            inputs = [rays, tree, found.ctypes.data]
            run(open_kernel(), len(rows), inputs, cpu(), workers=self.workers, work=RAY_WORK * len(rows))
        return (opens == 1).all(axis=0)

    def _cast_rows(
        self,
        rays: FaceRaysArgs,
        tree: AcceleratorArgs,
        *,
        rows: np.ndarray,
        surfaces: np.ndarray | None,
        blocks: InOrder,
    ) -> None:
        """Cast rays from the given faces, in blocks on several threads, and pass counts of hits to `blocks` in order.

        One thread computes a block, so that none waits for another.
        """
        size = max(1, min(_BLOCK, _BLOCK_RAYS // self.rays, -(-len(rows) // (4 * self.workers))))
        firsts = iter(range(0, len(rows), size))

        def part() -> None:
            for first in firsts:
                blocks.add_block(first // size, self._cast_block(rays, tree, rows[first : first + size], surfaces))

        if size >= len(rows):
            part()
        else:  # in an empty context, so that blocks do not replace the caller's progress bar
            parts, stop = [partial(Context().run, part) for _ in range(self.workers)], partial(deque, firsts, maxlen=0)
            uninterrupted(partial(share, parts, stop), stop)

    def _build_rays(self, scene: Scene) -> FaceRaysArgs:
        """Return the kernel argument that describes the rays of all faces.

        The addresses of the scene's arrays are valid as long as the mesh lives.
        """
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

    def _cast_block(
        self, of_all: FaceRaysArgs, tree: AcceleratorArgs, rows: np.ndarray, surfaces: np.ndarray | None
    ) -> Block:
        """Cast rays from a block of faces, and count how many hit each surface."""
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
