"""`print` of a result is short, whatever the number of points, and shows what it holds."""

import numpy as np
import pytest
import warp as wp

import warpsample as ws


@pytest.fixture(scope="module")
def courtyard():
    mesh = ws.load_mesh("courtyard")
    return mesh, ws.sample_surface(mesh, 2000, seed=1)


def test_a_result_prints_its_kind_points_mean_range_and_statuses(courtyard):
    mesh, points = courtyard
    found = ws.ambient_occlusion(mesh, points, 64, active=np.arange(2000) < 1500)
    text = repr(found)
    assert text.startswith("OpenShare of 2,000 points\n")
    assert f"mean {found.value.mean(dtype=np.float64):.4g}, 0 to {found.value.max():.4g}" in text
    assert "1,500 OK, 500 INACTIVE" in text
    assert "standard_error" in text


def test_results_print_a_few_lines(courtyard):
    mesh, points = courtyard
    directions = ws.sample_directions(points, 16, pdf=True)
    hits = ws.trace(mesh, points, directions.vectors)
    results = [mesh, points, directions, hits, ws.sky_matrix(mesh, points, 64), ws.view_factors(mesh, 16)]
    results += [ws.load_city("courtyard"), ws.sky_patches("tregenza"), ws.trace_all(mesh, points, directions.vectors)]
    results.append(ws.texture_points(mesh, np.tile(np.eye(3)[:, :2], (len(mesh.faces), 1, 1)), 4))
    for result in results:
        lines = repr(result).splitlines()
        assert 2 <= len(lines) <= 20, type(result)
        assert max(map(len, lines)) <= 120, type(result)
    assert f"{np.count_nonzero(np.isinf(hits.distance)):,} not finite" in repr(hits)


def test_notebooks_get_the_same_rows_as_a_table(courtyard):
    _, points = courtyard
    html = points._repr_html_()
    assert html.count("<tr>") == len(repr(points).splitlines()) - 1
    assert "<caption>SurfacePoints of 2,000 points</caption>" in html


def test_arrays_on_a_device_are_not_read():
    normals = wp.array(np.array([[0.0, 0.0, 1.0]], np.float32), dtype=wp.vec3, device="cpu")
    assert "(1, 4) vec3f on cpu" in repr(ws.sample_directions(normals, 4))


@pytest.mark.parametrize("value", [np.zeros(0, np.float32), np.full(3, np.nan, np.float32), np.zeros((0, 3), np.int64)])
def test_empty_and_undefined_arrays_print(value):
    from warpsample.host.summary import describe

    assert describe(value).startswith(str(value.shape))
