"""Functions (`wp.func`) and structs for user-defined Warp kernels: sampling, densities, sequences, frames and rays.

- `square_to_X(u, ...)` maps a point u of the unit square to a direction about +z. `square_to_X_pdf(w, ...)` returns the
  density of a direction w, per steradian unless the distribution lies in a plane. `X_to_square(w, ...)` is the inverse of
  `square_to_X`. Parameters, as float32, come last.
- `normal_to_reflection(m, view)` reflects the view at a normal m, and `reflection_to_normal(w, view)` returns the normal.
  The density of w is that of the normals times `normal_per_reflection(w, view)`. For visible normals,
  `X_per_cosine(m, ...)` / 4 is the density of w without cancellation.
- `normal_to_refraction(m, view, eta)`, `refraction_to_normal(w, view, eta)` and `normal_per_refraction(w, view, eta)` do
  the same for refraction. `fresnel_dielectric(cosine, eta)` is the share of light that is reflected. To choose between
  reflection and refraction, `third_uniform(u)` is a third uniform number, a hash of u.
- `sobol`, `fibonacci`, `r2`, `stratified`, `independent` and `philox` return a point of the unit square, a pure function of
  (seed: uint64, point: uint64, sample: uint32, count: uint32).
- `any_hit(tree, origin, direction, max_distance)` tests if a ray hits the mesh. `nearest_hit` returns (distance, face), and
  `transmitted` the fraction of light that the mesh transmits along the ray. `Tree` is the type of `warpsample.tree(mesh)`, a
  kernel argument. `offset_origin(tree, position, normal)` moves a ray's origin off the face.
- `Lobe` is the type of the second argument of functions passed to `warpsample.integrate`.
- `frame_about(n)` returns an orthonormal frame whose z axis is the unit normal n. `frame_along(n, tangent)` returns a
  frame with x along a tangent, and whether the tangent can be used. `to_world` and `to_local` convert directions between a
  frame and world coordinates.
"""

from warpsample.distributions.cosine_hemisphere import (
    cosine_hemisphere_to_square,
    cosine_hemisphere_to_square_concentric,
    square_to_cosine_hemisphere,
    square_to_cosine_hemisphere_concentric,
    square_to_cosine_hemisphere_inversion,
    square_to_cosine_hemisphere_offset,
    square_to_cosine_hemisphere_pdf,
)
from warpsample.distributions.lights.pixel_draws import (
    environment_map_to_square,
    square_to_environment_map,
    square_to_environment_map_pdf,
)
from warpsample.distributions.lights.spherical_rectangle import (
    spherical_rectangle_to_square,
    square_to_spherical_rectangle,
    square_to_spherical_rectangle_pdf,
)
from warpsample.distributions.lights.spherical_triangle import (
    spherical_triangle_to_square,
    square_to_spherical_triangle,
    square_to_spherical_triangle_pdf,
)
from warpsample.distributions.microfacets.beckmann import (
    anisotropic_beckmann_to_square,
    beckmann_to_square,
    square_to_anisotropic_beckmann,
    square_to_anisotropic_beckmann_pdf,
    square_to_beckmann,
    square_to_beckmann_pdf,
)
from warpsample.distributions.microfacets.ggx import (
    anisotropic_ggx_to_square,
    ggx_to_square,
    square_to_anisotropic_ggx,
    square_to_anisotropic_ggx_pdf,
    square_to_ggx,
    square_to_ggx_pdf,
)
from warpsample.distributions.microfacets.visible_beckmann import (
    anisotropic_visible_beckmann_per_cosine,
    anisotropic_visible_beckmann_to_square,
    square_to_anisotropic_visible_beckmann,
    square_to_anisotropic_visible_beckmann_pdf,
    square_to_visible_beckmann,
    square_to_visible_beckmann_pdf,
    visible_beckmann_per_cosine,
    visible_beckmann_to_square,
)
from warpsample.distributions.microfacets.visible_ggx import (
    anisotropic_visible_ggx_per_cosine,
    anisotropic_visible_ggx_to_square,
    square_to_anisotropic_visible_ggx,
    square_to_anisotropic_visible_ggx_pdf,
    square_to_visible_ggx,
    square_to_visible_ggx_pdf,
    visible_ggx_per_cosine,
    visible_ggx_to_square,
)
from warpsample.distributions.offset_ball import offset_ball_to_square, square_to_offset_ball, square_to_offset_ball_pdf
from warpsample.distributions.offset_circle import (
    offset_circle_to_square,
    square_to_offset_circle,
    square_to_offset_circle_pdf,
)
from warpsample.distributions.offset_disk import square_to_offset_disk, square_to_offset_disk_pdf
from warpsample.distributions.offset_sphere import (
    offset_sphere_to_square,
    square_to_offset_sphere,
    square_to_offset_sphere_pdf,
)
from warpsample.distributions.power_cosine import power_cosine_to_square, square_to_power_cosine, square_to_power_cosine_pdf
from warpsample.distributions.scattering.dielectric import (
    fresnel_dielectric,
    normal_per_refraction,
    normal_to_refraction,
    refraction_to_normal,
    third_uniform,
)
from warpsample.distributions.scattering.henyey_greenstein import (
    henyey_greenstein_to_square,
    square_to_henyey_greenstein,
    square_to_henyey_greenstein_pdf,
)
from warpsample.distributions.scattering.linearly_transformed_cosine import (
    linearly_transformed_cosine_to_square,
    square_to_linearly_transformed_cosine,
    square_to_linearly_transformed_cosine_pdf,
)
from warpsample.distributions.scattering.reflection import (
    normal_per_reflection,
    normal_to_reflection,
    reflection_to_normal,
)
from warpsample.distributions.uniform_cone import square_to_uniform_cone, square_to_uniform_cone_pdf, uniform_cone_to_square
from warpsample.distributions.uniform_disk import (
    square_to_uniform_disk,
    square_to_uniform_disk_concentric,
    square_to_uniform_disk_pdf,
    uniform_disk_to_square,
    uniform_disk_to_square_concentric,
)
from warpsample.distributions.uniform_hemisphere import (
    square_to_uniform_hemisphere,
    square_to_uniform_hemisphere_pdf,
    uniform_hemisphere_to_square,
)
from warpsample.distributions.uniform_sphere import (
    square_to_uniform_sphere,
    square_to_uniform_sphere_pdf,
    uniform_sphere_to_square,
)
from warpsample.distributions.von_mises_fisher import (
    square_to_von_mises_fisher,
    square_to_von_mises_fisher_pdf,
    von_mises_fisher_to_square,
)
from warpsample.estimate.integrand import Lobe
from warpsample.maths.frames import frame_about, frame_along, to_local, to_world
from warpsample.sequences.fibonacci import fibonacci
from warpsample.sequences.independent import independent
from warpsample.sequences.philox import philox
from warpsample.sequences.r2 import r2
from warpsample.sequences.sobol import sobol
from warpsample.sequences.stratified import stratified
from warpsample.tracing.own_rays import Tree, any_hit, nearest_hit, offset_origin, transmitted

__all__ = [
    "Lobe",
    "Tree",
    "anisotropic_beckmann_to_square",
    "anisotropic_ggx_to_square",
    "anisotropic_visible_beckmann_per_cosine",
    "anisotropic_visible_beckmann_to_square",
    "anisotropic_visible_ggx_per_cosine",
    "anisotropic_visible_ggx_to_square",
    "any_hit",
    "beckmann_to_square",
    "cosine_hemisphere_to_square",
    "cosine_hemisphere_to_square_concentric",
    "environment_map_to_square",
    "fibonacci",
    "frame_about",
    "frame_along",
    "fresnel_dielectric",
    "ggx_to_square",
    "henyey_greenstein_to_square",
    "independent",
    "linearly_transformed_cosine_to_square",
    "nearest_hit",
    "normal_per_reflection",
    "normal_per_refraction",
    "normal_to_reflection",
    "normal_to_refraction",
    "offset_ball_to_square",
    "offset_circle_to_square",
    "offset_origin",
    "offset_sphere_to_square",
    "philox",
    "power_cosine_to_square",
    "r2",
    "reflection_to_normal",
    "refraction_to_normal",
    "sobol",
    "spherical_rectangle_to_square",
    "spherical_triangle_to_square",
    "square_to_anisotropic_beckmann",
    "square_to_anisotropic_beckmann_pdf",
    "square_to_anisotropic_ggx",
    "square_to_anisotropic_ggx_pdf",
    "square_to_anisotropic_visible_beckmann",
    "square_to_anisotropic_visible_beckmann_pdf",
    "square_to_anisotropic_visible_ggx",
    "square_to_anisotropic_visible_ggx_pdf",
    "square_to_beckmann",
    "square_to_beckmann_pdf",
    "square_to_cosine_hemisphere",
    "square_to_cosine_hemisphere_concentric",
    "square_to_cosine_hemisphere_inversion",
    "square_to_cosine_hemisphere_offset",
    "square_to_cosine_hemisphere_pdf",
    "square_to_environment_map",
    "square_to_environment_map_pdf",
    "square_to_ggx",
    "square_to_ggx_pdf",
    "square_to_henyey_greenstein",
    "square_to_henyey_greenstein_pdf",
    "square_to_linearly_transformed_cosine",
    "square_to_linearly_transformed_cosine_pdf",
    "square_to_offset_ball",
    "square_to_offset_ball_pdf",
    "square_to_offset_circle",
    "square_to_offset_circle_pdf",
    "square_to_offset_disk",
    "square_to_offset_disk_pdf",
    "square_to_offset_sphere",
    "square_to_offset_sphere_pdf",
    "square_to_power_cosine",
    "square_to_power_cosine_pdf",
    "square_to_spherical_rectangle",
    "square_to_spherical_rectangle_pdf",
    "square_to_spherical_triangle",
    "square_to_spherical_triangle_pdf",
    "square_to_uniform_cone",
    "square_to_uniform_cone_pdf",
    "square_to_uniform_disk",
    "square_to_uniform_disk_concentric",
    "square_to_uniform_disk_pdf",
    "square_to_uniform_hemisphere",
    "square_to_uniform_hemisphere_pdf",
    "square_to_uniform_sphere",
    "square_to_uniform_sphere_pdf",
    "square_to_visible_beckmann",
    "square_to_visible_beckmann_pdf",
    "square_to_visible_ggx",
    "square_to_visible_ggx_pdf",
    "square_to_von_mises_fisher",
    "square_to_von_mises_fisher_pdf",
    "stratified",
    "third_uniform",
    "to_local",
    "to_world",
    "transmitted",
    "uniform_cone_to_square",
    "uniform_disk_to_square",
    "uniform_disk_to_square_concentric",
    "uniform_hemisphere_to_square",
    "uniform_sphere_to_square",
    "visible_beckmann_per_cosine",
    "visible_beckmann_to_square",
    "visible_ggx_per_cosine",
    "visible_ggx_to_square",
    "von_mises_fisher_to_square",
]
