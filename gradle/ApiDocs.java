import static java.util.Map.entry;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.File;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.jetbrains.dokka.ConfigurationJsonUtilsKt;
import org.jetbrains.dokka.DokkaGenerator;
import org.jetbrains.dokka.utilities.DokkaConsoleLogger;
import org.jetbrains.dokka.utilities.LoggingLevel;
import org.jetbrains.dokka.utilities.MessageEmitter;

/**
 * Writes a module's API documentation with Dokka, for builds without Dokka's plugin. Java runs this program from its source. The Dokka
 * formats on the class path determine the form of the documentation.
 *
 * <p>Arguments: the module's name, the output folder, the source folders and the class path of the compilation. The separator of a class
 * path separates the source folders and the entries of the class path.
 */
final class ApiDocs {
    private ApiDocs() {}

    public static void main(String[] arguments) throws Exception {
        if (arguments.length != 4) {
            throw new IllegalArgumentException("usage: ApiDocs MODULE OUTPUT SOURCES CLASSPATH");
        }
        Map<String, Object> sources = Map.ofEntries(
                entry("displayName", "JVM"),
                entry("sourceSetID", Map.of("scopeId", arguments[0], "sourceSetName", "main")),
                entry("analysisPlatform", "jvm"),
                entry("jdkVersion", 17),
                entry("noStdlibLink", true),
                entry("noJdkLink", true),
                entry("sourceRoots", paths(arguments[2])),
                entry("classpath", paths(arguments[3])));
        Map<String, Object> configuration = Map.ofEntries(
                entry("moduleName", arguments[0]),
                entry("outputDir", arguments[1]),
                entry("offlineMode", true),
                entry("failOnWarning", false),
                entry("sourceSets", List.of(sources)));
        String json = new ObjectMapper().writeValueAsString(configuration);
        new DokkaGenerator(
                        ConfigurationJsonUtilsKt.DokkaConfigurationImpl(json),
                        new DokkaConsoleLogger(LoggingLevel.WARN, MessageEmitter.Companion.getConsoleEmitter()))
                .generate();
    }

    private static List<String> paths(String joined) {
        return Stream.of(joined.split(File.pathSeparator))
                .filter(path -> new File(path).exists())
                .toList();
    }
}
