// Triangulations by JTS: Jts SITES 2 prints a face a line.
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.triangulate.DelaunayTriangulationBuilder;

public class Jts {
    public static void main(String[] arguments) throws Exception {
        Map<Coordinate, Integer> numbers = new HashMap<>();
        List<Coordinate> places = new ArrayList<>();
        for (String line : Files.readAllLines(Path.of(arguments[0]))) {
            String[] words = line.trim().split("\\s+");
            Coordinate place =
                new Coordinate(Double.parseDouble(words[0]), Double.parseDouble(words[1]));
            numbers.putIfAbsent(place, places.size());
            places.add(place);
        }
        DelaunayTriangulationBuilder builder = new DelaunayTriangulationBuilder();
        builder.setSites(places);
        Geometry made = builder.getTriangles(new GeometryFactory());
        StringBuilder text = new StringBuilder();
        for (int k = 0; k < made.getNumGeometries(); ++k) {
            Coordinate[] corners = made.getGeometryN(k).getCoordinates();
            for (int m = 0; m < 3; ++m) text.append(numbers.get(corners[m])).append(' ');
            text.append('\n');
        }
        System.out.print(text);
    }
}
