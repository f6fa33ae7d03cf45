from scipy.spatial import Delaunay

from lines import serve

serve(lambda points: Delaunay(points).simplices)
