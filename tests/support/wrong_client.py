"""Calls with a wrong option each, for `mypy --strict`: every line after the imports is an error."""

import warpsample as ws
import warpsample.cluster
import warpsample.rasters

ws.sky_view_factor(ws.load_mesh("a.ply"), ws.face_centers("a.ply"), upp=(0, 0, 1))
ws.sky_matrix(ws.load_mesh("a.ply"), ws.face_centers("a.ply"), tolerance=0.1)
ws.irradiation(ws.load_mesh("a.ply"), ws.face_centers("a.ply"), "athens", seed="0")
ws.thickness(ws.load_mesh("a.ply"), ws.face_centers("a.ply"), count=3)
warpsample.rasters.sky_view_factor("dsm.tif", crowns="trees.tif")
warpsample.rasters.sun_hours("dsm.tif", "athens", tolerance=0.1)
warpsample.cluster.sky_view_factor(ws.load_mesh("a.ply"), 100, falloff=1.0)
warpsample.cluster.integrate(ws.face_centers("a.ply"), None, 64, chunks=9)
