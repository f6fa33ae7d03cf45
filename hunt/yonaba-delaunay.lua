package.path = os.getenv("BUILDS") .. "/src/yonaba-delaunay/?.lua;" .. package.path
local Delaunay = require("delaunay")

-- Answers the cases of `circumspect campaign --worker` (docs/workers.md). An error ends the process with exit code 1.
for header in io.lines() do
  local points = {}
  local count = tonumber(header:match("^%d+"))
  for i = 1, count do
    local x, y = io.read("l"):match("(%S+) (%S+)")
    points[i] = Delaunay.Point(tonumber(x) + 0.0, tonumber(y) + 0.0) -- floats, as integers of Lua wrap
    points[i].own = i - 1
  end
  local made = Delaunay.triangulate(table.unpack(points))
  io.write(#made, "\n")
  for _, t in ipairs(made) do io.write(t.p1.own or count, " ", t.p2.own or count, " ", t.p3.own or count, "\n") end
  io.flush()
end
