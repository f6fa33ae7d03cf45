$LOAD_PATH.unshift "#{ENV['BUILDS']}/src/delaunator-ruby/lib"
require 'delaunator'

# Reads points from the standard input, writes triangles to the standard output.
while (header = $stdin.gets)
  points = Array.new(header.to_i) { $stdin.gets.split.map(&:to_f) }
  begin
    made = Delaunator.triangulate(points).each_slice(3).to_a
    puts "#{made.size} 3", made.map { |t| t.join(' ') }
  rescue StandardError => e
    puts "raised #{e.class}: #{e.message.lines.first}"
  end
  $stdout.flush
end
