"""Small classes that stand for the arrays of other libraries: each has one protocol alone."""


class Interface:
    """An array that has __array_interface__ and nothing else."""

    def __init__(self, array):
        self.__array_interface__ = array.__array_interface__
        self.owner = array


class Dlpack:
    """An array that has the two methods of DLPack and nothing else."""

    def __init__(self, array):
        self.owner = array

    def __dlpack__(self, **options):
        return self.owner.__dlpack__(**options)

    def __dlpack_device__(self):
        return self.owner.__dlpack_device__()


class Copies:
    """An array that gives itself to NumPy as a copy, as those of some libraries do."""

    def __init__(self, array):
        self.owner = array

    def __array__(self, dtype=None, copy=None):
        return self.owner.copy()
