package argo.build;

import java.io.File;
import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.xpath.XPath;
import javax.xml.xpath.XPathExpressionException;
import javax.xml.xpath.XPathFactory;
import javax.xml.xpath.XPathNodes;
import org.w3c.dom.Element;
import org.xml.sax.SAXException;

/**
 * Reads Maven's POMs for the Gradle build. The Gradle build declares no modules, versions or dependencies itself. This class fails if it
 * does not understand a dependency, a compiler plugin or a pattern of resources. It ignores Maven's other plugins: a build.gradle.kts
 * does their work.
 */
public final class Poms {
    /** Prints what Gradle reads about each module: {@code java Poms.java ROOT [PROPERTY=VALUE…]}. */
    public static void main(String[] arguments) {
        Map<String, String> given = new HashMap<>();
        Arrays.stream(arguments).skip(1).map(it -> it.split("=", 2)).forEach(it -> given.put(it[0], it[1]));
        Poms poms = new Poms(new File(arguments[0]), given);
        System.out.println(poms.group() + " " + poms.version());
        poms.modules().forEach(it -> System.out.println(poms.module(it)));
    }

    /**
     * A module, or another folder with a POM. Lists source and resource folders without the usual ones, as paths relative to the module.
     * Folders of Java sources end in {@code /java}.
     *
     * @param isLibrary whether the module is published
     * @param isSerialized whether the module is compiled with Kotlin's plugin for serialization
     * @param processors the coordinates of the annotation processors for Java
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
     * A dependency. Its Gradle configurations correspond to its scope in Maven.
     *
     * @param excluded the libraries to leave out, as {@code group:name}
     */
    public record Dependency(
            List<String> configurations,
            String group,
            String name,
            String version,
            boolean isModule,
            List<String> excluded) {
        public String coordinates() {
            return group + ":" + name + ":" + version;
        }
    }

    /**
     * A folder of resources.
     *
     * @param target the folder's path on the class path; empty: the root of the class path
     * @param files the names of the resources in the folder; empty: all files of the folder
     */
    public record Resource(String folder, String target, List<String> files) {}

    private static final XPath XPATH = XPathFactory.newDefaultInstance().newXPath();
    // a dependency of type pom is no library, it only makes Maven build another module first
    private static final String DEPENDENCIES =
            "dependencies/dependency[not(type='pom')]|profiles/profile/dependencies/dependency[not(type='pom')]";
    private static final String UNKNOWN =
            "*[not(self::groupId|self::artifactId|self::version|self::scope|self::exclusions)]"
                    + "|scope[.!='compile' and .!='provided' and .!='runtime' and .!='test']";
    private static final String FOLDERS =
            "build/*[self::sourceDirectory|self::testSourceDirectory][not(.=//sourceDirs/sourceDir)]";
    private static final Pattern PROPERTY = Pattern.compile("\\$\\{([^}]+)}");

    private final File root;
    private final Map<String, String> given;
    private final Element parent;
    private final Map<String, Element> managed = new HashMap<>(); // by group:name

    /**
     * Reads the POM in the folder {@code root}.
     *
     * @param given values of properties that replace those in the POM
     */
    public Poms(File root, Map<String, String> given) {
        this.root = root;
        this.given = given;
        this.parent = pom(root);
        at(parent, "dependencyManagement/dependencies/dependency")
                .forEach(it -> managed.put(text(it, "groupId", parent) + ":" + text(it, "artifactId", parent), it));
    }

    public String group() {
        return text("groupId");
    }

    public String version() {
        return text("version");
    }

    /** Returns the text of an element of the parent POM. {@code path} is a path such as {@code licenses/license/name}. */
    public String text(String path) {
        return text(parent, path, parent);
    }

    /** Returns the value of a property of the parent POM, such as {@code jason.version}. */
    public String property(String name) {
        return resolved("${" + name + "}", parent);
    }

    public List<String> modules() {
        return at(parent, "modules/module").map(Element::getTextContent).toList();
    }

    /** Returns the module in the folder {@code name}. The folder may also be another part of the build with a POM. */
    public Module module(String name) {
        Element pom = pom(new File(root, name));
        Stream<Element> poms = at(pom, "parent").findAny().isEmpty() ? Stream.of(pom) : Stream.of(parent, pom);
        refuse(pom, "a compiler's plugin", "//compilerPlugins/plugin[.!='kotlinx-serialization']");
        refuse(pom, "beside the sourceDirs of Kotlin", FOLDERS);
        return new Module(
                name,
                at(pom, "properties/maven.install.skip").findAny().isEmpty(),
                at(pom, "//compilerPlugins/plugin").findAny().isPresent(),
                poms.flatMap(it -> at(it, DEPENDENCIES))
                        .map(it -> dependency(it, pom))
                        .toList(),
                at(pom, "//annotationProcessorPaths/path")
                        .map(it -> dependency(it, pom).coordinates())
                        .toList(),
                sources(pom, "compile", "src/main/"),
                sources(pom, "test-compile", "src/test/"),
                resources(pom, "build/resources/resource", "src/main/resources"),
                resources(pom, "build/testResources/testResource", "src/test/resources"));
    }

    private Dependency dependency(Element it, Element pom) {
        String group = text(it, "groupId", pom);
        String name = text(it, "artifactId", pom);
        refuse(it, "for the dependency " + name, UNKNOWN);
        List<Element> declared = Stream.concat(Stream.of(it), Stream.ofNullable(managed.get(group + ":" + name)))
                .toList();
        String scope = at(it, "scope").map(Element::getTextContent).findAny().orElse("compile");
        return new Dependency(
                switch (scope) {
                    case "provided" -> List.of("compileOnly", "testImplementation");
                    case "runtime" -> List.of("runtimeOnly");
                    case "test" -> List.of("testImplementation");
                    default -> List.of("api"); // as in Maven, users of a library also compile with its dependencies
                },
                group,
                name,
                declared.stream()
                        .flatMap(each -> at(each, "version"))
                        .findFirst()
                        .map(each -> resolved(each.getTextContent(), pom))
                        .orElseThrow(() ->
                                new IllegalStateException(group + ":" + name + " has no version in " + place(pom))),
                group.equals(group()) && modules().contains(name),
                declared.stream()
                        .flatMap(each -> at(each, "exclusions/exclusion"))
                        .map(each -> text(each, "groupId", pom) + ":" + text(each, "artifactId", pom))
                        .toList());
    }

    /** Returns the folders of Kotlin and Java sources that an execution of Kotlin's compiler adds to the usual ones. */
    private List<String> sources(Element pom, String execution, String usual) {
        return at(
                        pom,
                        "//execution[id='" + execution + "']/configuration/sourceDirs/sourceDir[not(starts-with(.,'"
                                + usual + "'))]")
                .map(it -> resolved(it.getTextContent(), pom))
                .toList();
    }

    /**
     * Returns the folders of resources, without the usual one. Without a target, a pattern must be a whole folder of the module:
     * {@code name/**}. With a target, a pattern must be a file's name.
     */
    private List<Resource> resources(Element pom, String path, String usual) {
        String parts = path + "[includes and not(targetPath)]";
        refuse(pom, "with patterns", parts + "/directory[.!='${project.basedir}']");
        refuse(pom, "that is not a folder", parts + "/includes/include[substring-before(.,'/**')='']");
        refuse(pom, "that is not a file", path + "[targetPath]/includes/include[contains(.,'*')]");
        Stream<Resource> ofModule = at(pom, parts + "/includes/include")
                .map(it -> it.getTextContent().replace("/**", ""))
                .map(part -> new Resource(part, part, List.of()));
        Stream<Resource> folders = at(pom, path + "[(targetPath or not(includes)) and directory!='" + usual + "']")
                .map(it -> new Resource(
                        text(it, "directory", pom),
                        at(it, "targetPath")
                                .map(Element::getTextContent)
                                .findAny()
                                .orElse(""),
                        at(it, "includes/include").map(Element::getTextContent).toList()));
        return Stream.concat(ofModule, folders).toList();
    }

    private String text(Element it, String path, Element pom) {
        return at(it, path)
                .findFirst()
                .map(each -> resolved(each.getTextContent(), pom))
                .orElseThrow(() -> new IllegalStateException(
                        "there is no " + path + " in a <" + it.getTagName() + "> of " + place(pom)));
    }

    private String resolved(String text, Element pom) {
        return PROPERTY.matcher(text).replaceAll(match -> Matcher.quoteReplacement(value(match.group(1), pom)));
    }

    private String value(String name, Element pom) {
        if (name.startsWith("project.")) {
            return text(name.substring("project.".length()));
        }
        return Stream.concat(
                        Stream.ofNullable(given.get(name)),
                        Stream.of(pom, parent)
                                .flatMap(it -> at(it, "properties/" + name))
                                .map(Element::getTextContent))
                .findFirst()
                .map(it -> resolved(it, pom))
                .orElseThrow(() -> new IllegalStateException("there is no property " + name + " for " + place(pom)));
    }

    private static void refuse(Element it, String thing, String path) {
        at(it, path).findFirst().ifPresent(found -> {
            throw new IllegalStateException(
                    "the Gradle build does not know <" + found.getTagName() + ">" + found.getTextContent() + " " + thing
                            + " in " + place(it) + "; buildSrc/src/main/java/argo/build/Poms.java reads it");
        });
    }

    private static Element pom(File folder) {
        File file = new File(folder, "pom.xml");
        try (InputStream bytes = new FileInputStream(file)) {
            return DocumentBuilderFactory.newDefaultInstance()
                    .newDocumentBuilder()
                    .parse(bytes, file.getPath())
                    .getDocumentElement();
        } catch (IOException | SAXException | ParserConfigurationException reason) {
            throw new IllegalStateException(file + " cannot be read: " + reason.getMessage(), reason);
        }
    }

    private static String place(Element it) {
        return it.getOwnerDocument().getDocumentURI();
    }

    private static Stream<Element> at(Element it, String path) {
        try {
            XPathNodes found = XPATH.evaluateExpression(path, it, XPathNodes.class);
            return StreamSupport.stream(found.spliterator(), false).map(Element.class::cast);
        } catch (XPathExpressionException reason) {
            throw new IllegalArgumentException(path, reason);
        }
    }
}
