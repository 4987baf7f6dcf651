"""The command `warpsample bake` for a mesh with a Zarr store as output."""

from warpsample.cluster.baking import bake_job
from warpsample.cluster.clients import check_processes, computing
from warpsample.cluster.job import CHUNK, job_of
from warpsample.cluster.store import check_store
from warpsample.mesh.files import load_mesh
from warpsample.output.bake_rules import check_table
from warpsample.output.baked import BakeRun
from warpsample.output.faces_option import with_optics
from warpsample.output.quantities import quantity_of
from warpsample.output.run_record import RunRecord


def bake_run(run: BakeRun) -> str:
    """Compute the quantity of a `warpsample bake` command, and write the results into a Zarr store.

    Returns:
        a report for the terminal, in lines.

    Raises:
        TypeError, ValueError, FileNotFoundError: an argument that cannot be used, before anything is computed.
        KeyboardInterrupt: the run is interrupted; the message states how many points are done.
        OSError: the store cannot be written, another process is writing it, or the scheduler no longer answers.
    """
    check_table(run)
    store = check_store(run.output, "--output")
    check_processes(run.more.get("processes"))
    quantity, points, threads = (
        quantity_of(run.quantity),
        run.points if run.at is None else run.at,
        run.options.get("workers"),
    )
    options = quantity.arguments({name: value for name, value in run.options.items() if name != "workers"})
    record = RunRecord.of(quantity)
    with record.show(f"reading {run.mesh.name}"):
        mesh = with_optics(load_mesh(run.mesh), **run.optics)
        job = job_of(quantity.call.__name__, (mesh, points), options, run.more.get("chunk", CHUNK))
        with computing(run.more.get("cluster"), run.more.get("processes"), threads):
            bake_job(job, store, run.more.get("resume", False), "--output", record)
    return "\n  ".join([f"{run.output}: {quantity.title} of {job.total:,} {run.at or 'points'}", *record.describe()])
