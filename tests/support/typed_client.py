"""A client's script, as READMEs and journeys have it, for `mypy --strict`."""

import numpy as np
import pyvista as pv
import warp as wp
from numpy.typing import NDArray

import warpsample as ws
import warpsample.rasters
from warpsample import cluster, funcs, rasters


def openness(mesh: ws.Mesh, count: int) -> NDArray[np.float32]:
    points = ws.sample_surface(mesh, count, seed=0)
    found: ws.Estimate = ws.ambient_occlusion(mesh, points, 256, max_distance=30.0)
    lower, upper = found.interval(0.95)
    print(f"{found.value.mean():.2f}, {(upper - lower).mean():.3f}", found.counts(), found.skipped.points)
    return found.value


mesh = ws.load_mesh("courtyard")
print(openness(mesh, 100).shape)
mine = ws.as_mesh(([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [[0, 1, 2]]))
print(ws.Mesh([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [[0, 1, 2]]).face_areas)
eyes = ws.SurfacePoints(position=[[36.0, 36.0, 1.7]], normal=[[0, 0, 1]])
sky: ws.SkyView = ws.sky_view_factor(mesh, eyes, 64, up=(0, 0, 1))
print(sky.value.round(1), sky.below_horizon.max())
d = ws.sample_directions(ws.face_centers(mesh), 64, distribution=ws.CosineHemisphere(), sequence="sobol", pdf=True)
print(d.vectors[..., 2].mean(), d.vectors.shape, d.status)
if d.pdf is not None:
    print(d.pdf.min())
hits = ws.trace(mesh, ws.face_centers(mesh), d.vectors)
print(np.isfinite(hits.distance).mean(), hits.face.max())
lobe = ws.GGX(alpha=0.3)
u = ws.sample_square("sobol", points=1, count=4)[0]
w = lobe.sample(u)
print(lobe.pdf(w) > 0.0, lobe.invert(w).shape, ws.distributions.names(), ws.sequences.names())
v = ws.view_factors(mine, 64, groups=np.array(["a"]))
print(v.names, v.matrix.toarray(), v.sky, v.net_radiation(temperature=300.0, emissivity=0.9, outside=300.0).flux.sum())
year: ws.Irradiation = ws.irradiation(mesh, eyes, "athens")
print(year.value, year.hours, ws.to_frame(year, eyes))
made: pv.PolyData = found.to_polydata(eyes) if (found := ws.mean_distance(mesh, eyes)) else mesh.to_polydata()
city = ws.load_city("courtyard")
means, errors, areas = city.surface_means(year.value[:0], points=city.points(10))
print(city.surfaces.type, city.surfaces.area.sum(), means, errors, areas)
t = ws.texture_points(mesh, ws.load_uv("a.glb"), 64)
print(t.image(year.value).shape, t.report.overlapped)
print(rasters.sky_view_factor("dsm.tif").value, cluster.ambient_occlusion(mesh, 100).value)
print(ws.tree(mesh), funcs.sobol, wp.__name__, made.n_points, ws.sky_matrix(mesh, eyes).patches.directions)
print(
    ws.thickness(mesh, eyes, max_distance=3.0).value,
    warpsample.rasters.sun_hours("dsm.tif", "athens", tile=512, seed=1).value,
)
print(rasters.irradiation("dsm.tif", "athens", canopy="trees.tif", patches="tregenza", progress=True).value)
print(cluster.sky_view_factor(mesh, 100, 64, up=(0, 0, 1), seed=1, chunk=50).value)
print(cluster.integrate(eyes, funcs.square_to_cosine_hemisphere_pdf, 64, mesh=mesh, max_distance=3.0, chunk=50).value)
print(cluster.sample_directions(eyes, 64, pdf=True, seed=1).pdf, cluster.trace(mesh, 100, d.vectors, any_hit=True).distance)
