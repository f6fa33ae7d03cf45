from matplotlib.tri import Triangulation

from lines import serve

serve(lambda points: Triangulation([x for x, y in points], [y for x, y in points]).triangles)
