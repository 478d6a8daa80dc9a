"""Note on broken edges, for files that hold the outline alone."""


def edges_note(edge_break: float) -> str:
    """Note for the shop on the edges, broken by `edge_break` mm, for files of the outline alone; empty where sharp.

    Args:
        edge_break: leg of the chamfer on both edges, mm.
    """
    if edge_break == 0:
        return ""
    return f"afterwards break both edges of the outline by {edge_break:g} mm at 45 degrees: the rod rides between them"
