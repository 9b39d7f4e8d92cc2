package argo.build;

import java.io.File;
import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.SAXException;

/**
 * What Maven's POMs declare, for the Gradle build, which has no modules, versions and dependencies of its own. It reads the elements that
 * ARGO's POMs use, and fails on others that matter, since Gradle would build without them.
 */
public final class Poms {
    /** Prints what Gradle reads of each module: {@code java Poms.java ROOT [PROPERTY=VALUE…]}. */
    public static void main(String[] arguments) {
        Map<String, String> given = new HashMap<>();
        Stream.of(arguments).skip(1).map(it -> it.split("=", 2)).forEach(it -> given.put(it[0], it[1]));
        Poms poms = new Poms(new File(arguments[0]), given);
        System.out.println(poms.group() + " " + poms.version());
        poms.modules().forEach(System.out::println);
    }

    /**
     * A module, or another folder with a POM.
     *
     * @param isLibrary whether it is published
     * @param isSerialized whether it is compiled with Kotlin's plugin for serialization
     * @param processors the coordinates of Java's annotation processors
     * @param sources the folders of Kotlin sources besides the usual ones, relative to the module's
     */
    public record Module(
            String name,
            boolean isLibrary,
            boolean isSerialized,
            List<Dependency> dependencies,
            List<String> processors,
            List<String> sources,
            List<String> testSources,
            List<Resource> resources,
            List<Resource> testResources) {}

    /**
     * A dependency of a module.
     *
     * @param configurations the names of Gradle's configurations that mean its scope
     * @param isModule whether it is one of this build
     * @param excluded the libraries that it does not bring, as {@code group:name}
     */
    public record Dependency(
            List<String> configurations, String group, String name, String version, boolean isModule, List<String> excluded) {
        public String coordinates() {
            return group + ":" + name + ":" + version;
        }
    }

    /** A folder of resources besides the usual one, and the folder on the class path that they are put into, empty for its top. */
    public record Resource(String folder, String target) {}

    private static final Set<String> OF_A_DEPENDENCY = Set.of("groupId", "artifactId", "version", "scope", "type", "exclusions");
    private static final Pattern PROPERTY = Pattern.compile("\\$\\{([^}]+)}");

    private final File root;
    private final Map<String, String> given;
    private final Element parent;
    private final Map<String, Element> managed = new HashMap<>();

    /**
     * Reads the POM in the folder {@code root}.
     *
     * @param given values of properties that replace those in the POM
     */
    public Poms(File root, Map<String, String> given) {
        this.root = root;
        this.given = given;
        this.parent = pom(root);
        at(parent, "dependencyManagement", "dependencies", "dependency").forEach(it -> managed.put(key(it, parent), it));
    }

    public String group() {
        return text(parent, "groupId", parent);
    }

    public String version() {
        return text(parent, "version", parent);
    }

    /** The text of an element of the parent, given by its path: {@code text("licenses", "license", "name")}. */
    public String text(String... path) {
        return resolved(only(parent, path).getTextContent(), parent);
    }

    /** The value of a property of the parent, such as {@code jason.version}. */
    public String property(String name) {
        return resolved("${" + name + "}", parent);
    }

    /** The modules in the order of the parent. */
    public List<Module> modules() {
        return names().stream().map(this::module).toList();
    }

    /** The module of the folder {@code name}, or what else has a POM there. */
    public Module module(String name) {
        Element pom = pom(new File(root, name));
        List<Dependency> dependencies = new ArrayList<>();
        for (Element from : at(pom, "parent").isEmpty() ? List.of(pom) : List.of(parent, pom)) {
            Stream.concat(at(from, "dependencies", "dependency").stream(), at(from, "profiles", "profile", "dependencies", "dependency").stream())
                    .filter(it -> at(it, "type").isEmpty()) // of type pom: no library, but a module that is built before
                    .forEach(it -> dependencies.add(dependency(it, pom)));
        }
        return new Module(
                name,
                !properties(pom).containsKey("maven.install.skip"),
                isSerialized(pom),
                dependencies,
                all(pom, "annotationProcessorPaths").stream()
                        .flatMap(it -> at(it, "path").stream())
                        .map(it -> dependency(it, pom).coordinates())
                        .toList(),
                sources(pom, "compile", "src/main/"),
                sources(pom, "test-compile", "src/test/"),
                resources(pom, "src/main/resources", "build", "resources", "resource"),
                resources(pom, "src/test/resources", "build", "testResources", "testResource"));
    }

    private List<String> names() {
        return at(parent, "modules", "module").stream().map(Element::getTextContent).toList();
    }

    private Dependency dependency(Element it, Element pom) {
        at(it, "*").stream().filter(part -> !OF_A_DEPENDENCY.contains(part.getTagName())).findFirst().ifPresent(part -> {
            throw unknown("<" + part.getTagName() + "> of the dependency " + key(it, pom), pom);
        });
        Element from = managed.get(key(it, pom));
        if (at(it, "version").isEmpty() && from == null) {
            throw new IllegalStateException(key(it, pom) + " has no version in " + pom.getBaseURI() + " and in its parent");
        }
        String version = at(it, "version").isEmpty() ? text(from, "version", parent) : text(it, "version", pom);
        String scope = at(it, "scope").isEmpty() ? "compile" : text(it, "scope", pom);
        List<String> configurations = switch (scope) {
            case "compile" -> List.of("api"); // as Maven does: what a library's users compile with, too
            case "provided" -> List.of("compileOnly", "testImplementation");
            case "runtime" -> List.of("runtimeOnly");
            case "test" -> List.of("testImplementation");
            default -> throw unknown("the scope " + scope + " of the dependency " + key(it, pom), pom);
        };
        List<String> excluded = Stream.of(it, from == null ? it : from)
                .flatMap(each -> at(each, "exclusions", "exclusion").stream())
                .map(each -> key(each, pom))
                .distinct()
                .toList();
        String group = text(it, "groupId", pom);
        String name = text(it, "artifactId", pom);
        return new Dependency(configurations, group, name, version, group.equals(group()) && names().contains(name), excluded);
    }

    private boolean isSerialized(Element pom) {
        List<String> plugins = all(pom, "compilerPlugins").stream().flatMap(it -> at(it, "plugin").stream()).map(Element::getTextContent).toList();
        if (!List.of("kotlinx-serialization").containsAll(plugins)) {
            throw unknown("the compiler's plugins " + plugins, pom);
        }
        return !plugins.isEmpty();
    }

    /** What an execution of Kotlin's compiler has besides the usual folders. */
    private List<String> sources(Element pom, String execution, String usual) {
        return all(pom, "execution").stream()
                .filter(it -> at(it, "id").stream().anyMatch(id -> id.getTextContent().equals(execution)))
                .flatMap(it -> at(it, "configuration", "sourceDirs", "sourceDir").stream())
                .map(it -> resolved(it.getTextContent(), pom))
                .filter(it -> !it.startsWith(usual))
                .toList();
    }

    private List<Resource> resources(Element pom, String usual, String... path) {
        List<Resource> resources = new ArrayList<>();
        for (Element it : at(pom, path)) {
            String folder = text(it, "directory", pom);
            for (Element pattern : at(it, "includes", "include")) {
                String name = pattern.getTextContent();
                if (!name.endsWith("/**") || name.indexOf('*') < name.length() - 2) {
                    throw unknown("the pattern " + name + ", which is not a folder's", pom);
                }
                String part = name.substring(0, name.length() - "/**".length());
                resources.add(new Resource(folder + "/" + part, part));
            }
            if (at(it, "includes").isEmpty() && !folder.equals(usual)) {
                resources.add(new Resource(folder, at(it, "targetPath").isEmpty() ? "" : text(it, "targetPath", pom)));
            }
        }
        return resources;
    }

    private String key(Element it, Element pom) {
        return text(it, "groupId", pom) + ":" + text(it, "artifactId", pom);
    }

    private String text(Element it, String tag, Element pom) {
        return resolved(only(it, tag).getTextContent(), pom);
    }

    private String resolved(String text, Element pom) {
        return PROPERTY.matcher(text).replaceAll(match -> Matcher.quoteReplacement(value(match.group(1), pom)));
    }

    private String value(String name, Element pom) {
        if (name.equals("project.basedir")) {
            return ".";
        }
        if (name.equals("project.version")) {
            return version();
        }
        if (name.equals("project.groupId")) {
            return group();
        }
        String value = Stream.of(given, properties(pom), properties(parent))
                .map(it -> it.get(name))
                .filter(it -> it != null)
                .findFirst()
                .orElseThrow(() -> new IllegalStateException(pom.getBaseURI() + " has no property " + name + ", nor has its parent"));
        return resolved(value, pom);
    }

    private static Map<String, String> properties(Element pom) {
        Map<String, String> properties = new HashMap<>();
        at(pom, "properties", "*").forEach(it -> properties.put(it.getTagName(), it.getTextContent()));
        return properties;
    }

    private static Element pom(File folder) {
        File file = new File(folder, "pom.xml");
        try (InputStream bytes = new FileInputStream(file)) {
            return DocumentBuilderFactory.newDefaultInstance().newDocumentBuilder().parse(bytes, file.getPath()).getDocumentElement();
        } catch (IOException | SAXException | ParserConfigurationException reason) {
            throw new IllegalStateException(file + " cannot be read: " + reason.getMessage(), reason);
        }
    }

    private static Element only(Element it, String... path) {
        List<Element> found = at(it, path);
        if (found.size() != 1) {
            throw new IllegalStateException("not one but " + found.size() + " of <" + String.join("> <", path) + "> in <" + it.getTagName() + ">: "
                    + it.getTextContent().strip());
        }
        return found.get(0);
    }

    /** The elements below {@code it} that a path of tags leads to; {@code *} is any tag. */
    private static List<Element> at(Element it, String... path) {
        List<Element> found = List.of(it);
        for (String tag : path) {
            found = found.stream()
                    .flatMap(each -> elements(each.getChildNodes()))
                    .filter(each -> tag.equals("*") || each.getTagName().equals(tag))
                    .toList();
        }
        return found;
    }

    private static List<Element> all(Element it, String tag) {
        return elements(it.getElementsByTagName(tag)).toList();
    }

    private static Stream<Element> elements(NodeList nodes) {
        return IntStream.range(0, nodes.getLength()).mapToObj(nodes::item).filter(Element.class::isInstance).map(Element.class::cast);
    }

    private static IllegalStateException unknown(String thing, Element pom) {
        return new IllegalStateException(
                "the Gradle build does not know " + thing + " in " + pom.getBaseURI() + "; buildSrc/src/main/java/argo/build/Poms.java reads the POMs");
    }
}
