# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part in the 3D view: its faces coloured by the error, the exaggerated shape, and the ideal one beside it.

Everything is drawn in the scene graph in front of the machine; no object of the document is touched.  Objects are
hidden by the switch of their own nodes, which the document does not store.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from pivy import coin

from ..studies.part_shape import together
from .colormap import NO_DATA, Scale
from .legend import unbounded
from .pointers import outlines_of

FINENESS, MOST_TRIANGLES = 60.0, 9000  # the part's size over the longest edge of its mesh; triangles of one face
IDEAL_COLOUR, EDGE_COLOUR, CHOSEN_COLOUR = (0.80, 0.82, 0.85), (0.15, 0.18, 0.22), (0.95, 0.60, 0.05)
UNCUT = tuple(0.72 * c for c in NO_DATA)
BESIDE = 1.3  # of its width, for the ideal part


@dataclass
class _Mesh:
    """vertices (v, 3) mm, triangles (t, 3), moved (v, 3) mm and value (v,) mm or None where nothing is known."""

    vertices: np.ndarray
    triangles: np.ndarray
    moved: np.ndarray | None = None
    value: np.ndarray | None = None


def refined(vertices, triangles, longest: float, most: int = MOST_TRIANGLES) -> tuple[np.ndarray, np.ndarray]:
    """The mesh with every triangle cut into four until no edge is longer than `longest` mm, or there are `most`."""
    vertices, triangles = np.asarray(vertices, dtype=float), np.asarray(triangles, dtype=int).reshape(-1, 3)
    while len(triangles) and 4 * len(triangles) <= most:
        pairs = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        if np.linalg.norm(vertices[pairs[:, 0]] - vertices[pairs[:, 1]], axis=1).max() <= longest:
            break
        edges, where = np.unique(pairs, axis=0, return_inverse=True)
        middle = len(vertices) + where.reshape(-1, 3)
        vertices = np.concatenate([vertices, vertices[edges].mean(axis=1)])
        a, b, c = triangles.T
        ab, bc, ca = middle.T
        triangles = np.concatenate([np.stack(t, axis=1) for t in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))])
    return vertices, triangles


class PartScene:
    """The nodes of a part.  `root` goes into the scene graph; `body` is what a camera is fitted to."""

    def __init__(self, faces):
        """faces : (name, Part.Face) of the part, in document coordinates."""
        self.root, self.body = unbounded(), coin.SoSeparator()
        front = coin.SoDepthBuffer()
        front.range = (0.0, 0.01)  # in front of the machine, and in the right order among themselves
        self._ideal_switch, self._edges = coin.SoSwitch(), coin.SoSeparator()
        self._coloured = coin.SoSeparator()
        for node in (coin.SoResetTransform(), front, self._coloured, self._edges, self._ideal_switch):
            self.body.addChild(node)
        self.root.addChild(self.body)
        shapes = [face for _, face in faces]
        box = shapes[0].BoundBox
        for shape in shapes[1:]:
            box.add(shape.BoundBox)
        self.size, self.width = box.DiagonalLength, box.XLength
        self.meshes, self._nodes = {}, {}
        for name, face in faces:
            points, triangles = face.tessellate(max(1e-3, self.size / 800))
            if triangles:
                mesh = _Mesh(*refined([tuple(p) for p in points], triangles, self.size / FINENESS))
                self.meshes[name] = mesh
                self._nodes[name] = self._face_nodes(mesh)
        self.shape(0.0)
        self._draw_edges(shapes)
        self._draw_ideal()

    def _face_nodes(self, mesh):
        node, material, binding = coin.SoSeparator(), coin.SoMaterial(), coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED
        sides = coin.SoShapeHints()
        sides.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        sides.creaseAngle = 0.5
        coordinates, faces = coin.SoCoordinate3(), coin.SoIndexedFaceSet()
        indices = np.concatenate([mesh.triangles, np.full((len(mesh.triangles), 1), -1)], axis=1).ravel().tolist()
        faces.coordIndex.setValues(0, len(indices), indices)
        material.diffuseColor.setNum(len(mesh.vertices))
        material.diffuseColor.setValues(0, len(mesh.vertices), [UNCUT] * len(mesh.vertices))
        for child in (sides, material, binding, coordinates, faces):
            node.addChild(child)
        self._coloured.addChild(node)
        return node, material, coordinates

    def _draw_edges(self, shapes) -> None:
        lines = outlines_of(shapes)
        if not lines:
            return
        flat, style, material = coin.SoLightModel(), coin.SoDrawStyle(), coin.SoMaterial()
        flat.model, style.lineWidth, material.diffuseColor = coin.SoLightModel.BASE_COLOR, 1.5, EDGE_COLOUR
        coordinates, shape = coin.SoCoordinate3(), coin.SoLineSet()
        points = [p for line in lines for p in line]
        coordinates.point.setValues(0, len(points), points)
        shape.numVertices.setValues(0, len(lines), [len(line) for line in lines])
        for child in (flat, style, material, coordinates, shape):
            self._edges.addChild(child)

    def _draw_ideal(self) -> None:
        node, place, material = coin.SoSeparator(), coin.SoTranslation(), coin.SoMaterial()
        place.translation = (BESIDE * self.width, 0.0, 0.0)
        material.diffuseColor = IDEAL_COLOUR
        sides = coin.SoShapeHints()
        sides.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        sides.creaseAngle = 0.5
        for child in (place, sides, material, self._edges):
            node.addChild(child)
        for mesh in self.meshes.values():
            coordinates, faces = coin.SoCoordinate3(), coin.SoIndexedFaceSet()
            coordinates.point.setValues(0, len(mesh.vertices), [tuple(p) for p in mesh.vertices.tolist()])
            indices = np.concatenate([mesh.triangles, np.full((len(mesh.triangles), 1), -1)], axis=1).ravel().tolist()
            faces.coordIndex.setValues(0, len(indices), indices)
            part = coin.SoSeparator()
            part.addChild(coordinates)
            part.addChild(faces)
            node.addChild(part)
        self._ideal_switch.addChild(node)
        self._ideal_switch.whichChild = coin.SO_SWITCH_NONE

    # -- what is shown -------------------------------------------------------------------------------------------------
    def show_ideal(self, shown: bool) -> None:
        """Draw the ideal part beside, or not."""
        self._ideal_switch.whichChild = coin.SO_SWITCH_ALL if shown else coin.SO_SWITCH_NONE

    def fill(self, fields) -> None:
        """Take the errors of the faces.  fields : name -> `FaceField`; other faces become grey, and follow the rest."""
        whole = together(fields.values()) if fields else None
        for name, mesh in self.meshes.items():
            mesh.moved = None if whole is None else whole.at(mesh.vertices)[0]
            field = fields.get(name)
            mesh.value = None
            if field is not None:
                mesh.value = field.wall(mesh.vertices) if field.axial else field.at(mesh.vertices)[1]

    def paint(self, scale: Scale, chosen: str = "") -> None:
        """Colour the faces by their values in um; the chosen one has a bright edge of its own colour."""
        for name, (_, material, _) in self._nodes.items():
            value = self.meshes[name].value
            count = len(self.meshes[name].vertices)
            colours = [UNCUT] * count if value is None else [scale.colour(1e3 * v) for v in value.tolist()]
            material.diffuseColor.setNum(count)
            material.diffuseColor.setValues(0, count, colours)
            bright = 0.0 if value is None else 0.14  # the light of the view must not make zero look like no value
            material.emissiveColor = (0.30, 0.20, 0.0) if name == chosen else (bright,) * 3

    def shape(self, times: float) -> None:
        """Draw the errors `times` as large as they are."""
        for name, (_, _, coordinates) in self._nodes.items():
            mesh = self.meshes[name]
            places = mesh.vertices if mesh.moved is None else mesh.vertices + times * mesh.moved
            coordinates.point.setNum(len(places))
            coordinates.point.setValues(0, len(places), [tuple(p) for p in places.tolist()])

    @property
    def largest(self) -> float:
        """Largest length of an error, mm."""
        return max((float(np.linalg.norm(m.moved, axis=1).max()) for m in self.meshes.values() if m.moved is not None),
                   default=0.0)  # fmt: skip

    # -- picking -------------------------------------------------------------------------------------------------------
    def face_at(self, view, place) -> str:
        """Name of the face below a pixel (x, y) of a view, counted from its lower left corner, or ""."""
        camera = view.getCameraNode()
        around = coin.SoSeparator()
        around.ref()
        around.addChild(camera)
        around.addChild(self._coloured)
        action = coin.SoRayPickAction(coin.SbViewportRegion(*(int(v) for v in view.getSize())))
        action.setPoint(coin.SbVec2s(int(place[0]), int(place[1])))
        action.setRadius(2.0)
        action.apply(around)
        hit = action.getPickedPoint()
        found = ""
        if hit is not None:
            path = hit.getPath()
            for name, (node, _, _) in self._nodes.items():
                if path.findNode(node) >= 0:
                    found = name
        around.unref()
        return found


class Hidden:
    """Objects that are not drawn for a while, by the switches of their nodes; the document does not notice."""

    def __init__(self):
        self._kept = []

    def hide(self, objects) -> None:
        """Hide these objects, and show those that were hidden before."""
        self.show()
        for obj in objects:
            switch = getattr(getattr(obj, "ViewObject", None), "SwitchNode", None)
            if switch is not None and switch.whichChild.getValue() != coin.SO_SWITCH_NONE:
                self._kept.append((switch, switch.whichChild.getValue()))
                switch.whichChild = coin.SO_SWITCH_NONE

    def show(self) -> None:
        """Draw everything as before."""
        for switch, value in self._kept:
            switch.whichChild = value
        self._kept = []
