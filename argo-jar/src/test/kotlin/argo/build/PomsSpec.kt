package argo.build

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.nio.file.Path
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** Tests what the Gradle build reads from the POMs. */
class PomsSpec : FunSpec({
    val root = Path.of("..")

    fun poms(tree: Path, given: Map<String, String> = emptyMap()) = Poms(tree.toFile(), given)

    /** Returns one line for each module of [tree]. */
    fun read(tree: Path, given: Map<String, String> = emptyMap()): String =
        poms(tree, given).let { poms -> poms.modules().joinToString("\n") { "${poms.module(it)}" } }

    fun refusal(tree: Path): String = shouldThrow<IllegalStateException> { read(tree) }.message.orEmpty()

    fun tree(vararg module: String): Path = tempdir().toPath().apply {
        resolve("pom.xml").writeText(PARENT)
        module.forEachIndexed { at, text ->
            resolve("m$at").createDirectories().resolve("pom.xml").writeText("<project><parent/>$text</project>")
        }
    }

    fun withDependency(text: String) = tree("<dependencies><dependency>$text</dependency></dependencies>", "")

    fun dependency(text: String) = read(withDependency(text))

    test("all modules of this repository are read, in the order of Maven, and their group and version") {
        val pom = root.resolve("pom.xml").readText()
        val modules = Regex("<module>(.+)</module>").findAll(pom).map { it.groupValues[1] }.toList()
        modules shouldContainAll listOf("javino-java", "argo-arch", "argo-jar", "samples")
        val java = "${System.getProperty("java.home")}/bin/java"
        val process = ProcessBuilder(java, "-XX:TieredStopAtLevel=1", "../buildSrc/src/main/java/argo/build/Poms.java", "$root")
            .redirectErrorStream(true).start()
        val read = process.inputStream.bufferedReader().readLines()
        read.first() shouldBe "argo ${Regex("<version>(.+)</version>").find(pom)!!.groupValues[1]}"
        read.drop(1).map { it.substringAfter("[name=").substringBefore(",") } shouldBe modules
    }

    mapOf(
        "" to "[api]", "<scope>provided</scope>" to "[compileOnly, testImplementation]", "<scope>runtime</scope>" to "[runtimeOnly]",
        "<scope>test</scope>" to "[testImplementation]",
    ).forEach { (scope, configurations) ->
        test("Gradle's $configurations is Maven's scope ${scope.ifEmpty { "compile" }}") {
            dependency("<groupId>g</groupId><artifactId>a</artifactId><version>1</version>$scope") shouldContain
                "Dependency[configurations=$configurations, group=g, name=a, version=1, isModule=false, excluded=[]]"
        }
    }

    test("a managed library has its version and exclusions from the parent, unless the module names a version") {
        dependency("<groupId>g</groupId><artifactId>managed</artifactId>") shouldContain
            "name=managed, version=2.0, isModule=false, excluded=[x:y]"
        dependency("<groupId>g</groupId><artifactId>managed</artifactId><version>3</version>") shouldContain
            "name=managed, version=3, isModule=false, excluded=[x:y]"
    }

    test("what all modules need and what only tests need is read too") {
        dependency("<groupId>g</groupId><artifactId>a</artifactId><version>1</version>").let {
            it shouldContain "name=for-all, version=4"
            it shouldContain "configurations=[testImplementation], group=g, name=for-tests, version=5"
        }
    }

    test("a module that needs another one depends on its project") {
        dependency("<groupId>\${project.groupId}</groupId><artifactId>m1</artifactId>") shouldContain
            "group=of.this, name=m1, version=0.9, isModule=true"
    }

    test("a given property replaces the one of the POM") {
        val tree = tree("", "<dependencies><dependency><groupId>g</groupId><artifactId>managed</artifactId></dependency></dependencies>")
        read(tree, mapOf("managed.version" to "7")) shouldContain "name=managed, version=7"
    }

    test("the group of the libraries is one property for Gradle") {
        val given = mapOf("argo.group" to "org.example.robots")
        poms(root, given).group() shouldBe "org.example.robots"
        val read = read(root, given)
        read shouldNotContain "group=argo,"
        read shouldContain "group=org.example.robots, name=argo-arch, version"
    }

    test("the group of the libraries is one property for Maven, and the POMs that others get have neither it nor a parent")
        .config(tags = setOf(NamedTag("Thorough"))) {
            val tree = tempdir().toPath()
            val modules = Regex("<module>(.+)</module>").findAll(root.resolve("pom.xml").readText()).map { it.groupValues[1] }
            (modules + "").forEach { root.resolve(it).resolve("pom.xml").copyTo(tree.resolve(it).createDirectories().resolve("pom.xml")) }
            val maven = listOf(
                "mvn", "-o", "-q", "-B", "-f", "$tree/pom.xml", "verify", "-pl", "argo-arch", "-am",
                "-Dmaven.test.skip=true", "-Dargo.group=org.example.robots",
            )
            val process = ProcessBuilder(maven).redirectErrorStream(true).start()
            val said = process.inputStream.readBytes().decodeToString()
            withClue(said) { process.waitFor() shouldBe 0 }
            val pom = tree.resolve("argo-arch/target/flattened-pom.xml").readText()
            pom shouldContain "<groupId>org.example.robots</groupId>\n      <artifactId>javino-java</artifactId>\n      <version>"
            listOf("\${", "<parent>", "<scope>test</scope>").forEach { pom shouldNotContain it }
        }

    test("folders of sources and resources besides the usual ones are read") {
        fun execution(id: String, vararg folders: String) = "<execution><id>$id</id><configuration><sourceDirs>" +
            folders.joinToString("") { "<sourceDir>$it</sourceDir>" } + "</sourceDirs></configuration></execution>"
        val build = "<build><resources><resource><directory>src/main/resources</directory></resource>" +
            "<resource><directory>\${project.basedir}</directory><includes><include>demo/**</include></includes></resource>" +
            "<resource><directory>rules</directory><targetPath>filters</targetPath></resource><resource><directory>../docs</directory>" +
            "<includes><include>a.md</include></includes><targetPath>pages</targetPath></resource></resources>" +
            "<plugins><plugin><executions>" +
            execution("compile", "src/main/kotlin", "src/more/kotlin") + execution("test-compile", "src/test/kotlin", "../m1/src/shared") +
            "</executions></plugin></plugins></build>"
        val read = read(tree(build, ""))
        read shouldContain "sources=[src/more/kotlin], testSources=[../m1/src/shared], " +
            "resources=[Resource[folder=demo, target=demo, files=[]], Resource[folder=rules, target=filters, files=[]], " +
            "Resource[folder=../docs, target=pages, files=[a.md]]]"
    }

    mapOf(
        "<groupId>g</groupId><artifactId>a</artifactId><version>1</version><type>zip</type>" to "<type>zip for the dependency a",
        "<groupId>g</groupId><artifactId>a</artifactId><version>1</version><scope>system</scope>" to "<scope>system for the dependency a",
        "<groupId>g</groupId><artifactId>a</artifactId>" to "g:a has no version",
        "<groupId>g</groupId><artifactId>a</artifactId><version>\${none}</version>" to "there is no property none",
    ).forEach { (text, reason) ->
        test("it is not left out in silence, but refused with its file: $reason") {
            val said = refusal(withDependency(text))
            said shouldContain reason
            said shouldContain "m0/pom.xml"
        }
    }

    test("a folder of sources that only Java's compiler has in Maven is refused") {
        refusal(tree("<build><sourceDirectory>src/odd/java</sourceDirectory></build>", "")) shouldContain
            "<sourceDirectory>src/odd/java beside the sourceDirs of Kotlin in"
    }

    test("the settings of this build find the modules and Kotlin's version where the POM has them") {
        val settings = root.resolve("settings.gradle.kts").readText()
        val patterns = Regex("Regex\\(\"(.+?)\"\\)").findAll(settings).map { it.groupValues[1] }.toList()
        val pom = root.resolve("pom.xml").readText()
        patterns.associateWith { pattern -> Regex(pattern).findAll(pom).count() } shouldBe
            mapOf("<kotlin.version>(.+)</kotlin.version>" to 1, "<module>(.+)</module>" to poms(root).modules().size)
    }

    test("a new project's Gradle build fetches its plugins from where this one does") {
        val repositories = Regex("pluginManagement \\{\\s+repositories \\{ (.+?) }")
        fun repositories(file: String) = repositories.find(root.resolve(file).readText())?.groupValues?.get(1)
        repositories("settings.gradle.kts") shouldBe "mavenCentral()"
        repositories("argo-tools/src/main/resources/argo/tools/project/settings.gradle") shouldBe "mavenCentral()"
    }
})

private const val PARENT = """<project>
  <groupId>of.this</groupId><version>0.9</version>
  <modules><module>m0</module><module>m1</module></modules>
  <properties><managed.version>2.0</managed.version></properties>
  <dependencyManagement><dependencies>
    <dependency>
      <groupId>g</groupId><artifactId>managed</artifactId><version>${'$'}{managed.version}</version>
      <exclusions><exclusion><groupId>x</groupId><artifactId>y</artifactId></exclusion></exclusions>
    </dependency>
    <dependency><groupId>${'$'}{project.groupId}</groupId><artifactId>m1</artifactId><version>${'$'}{project.version}</version></dependency>
  </dependencies></dependencyManagement>
  <dependencies><dependency><groupId>g</groupId><artifactId>for-all</artifactId><version>4</version></dependency></dependencies>
  <profiles><profile><id>tests</id><dependencies>
    <dependency><groupId>g</groupId><artifactId>for-tests</artifactId><version>5</version><scope>test</scope></dependency>
  </dependencies></profile></profiles>
</project>"""
