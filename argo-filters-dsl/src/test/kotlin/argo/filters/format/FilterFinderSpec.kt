package argo.filters.format

import argo.filters.FilterException
import argo.filters.FilterNotFoundException
import argo.filters.PerceptionFilter
import argo.filters.Rule
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FreeSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.net.URLClassLoader
import java.nio.file.Files
import java.nio.file.Path
import java.util.jar.JarEntry
import java.util.jar.JarOutputStream
import kotlin.io.path.createDirectories
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.outputStream
import kotlin.io.path.writeText

private fun document(predicate: String) = XmlFilters.write(PerceptionFilter("any", Rule(predicate)))

private fun Path.filter(name: String, predicate: String = "d"): Path =
    resolve(name).also { it.parent.createDirectories() }.apply { writeText(document(predicate)) }

private fun PerceptionFilter.predicate() = rules.single().predicate.functor

class FilterFinderSpec : FreeSpec({
    fun project() = tempdir().toPath()
    val noResources = URLClassLoader(emptyArray(), null)

    "a filter is found by name" - {
        val project = project()
        project.filter("a.xml", "in_project")
        project.filter("filters/b.xml", "in_filters")
        project.filter("filters/night/c.xml", "in_folder")
        val finder = FilterFinder(project, noResources)

        "in the project's directory" { finder.find("a").predicate() shouldBe "in_project" }
        "in filters/ under it" { finder.find("b").predicate() shouldBe "in_filters" }
        "in a folder" { finder.find("night/c").predicate() shouldBe "in_folder" }
        "with its extension" { finder.find("b.xml").predicate() shouldBe "in_filters" }
        "and is called by its name without extension" { finder.find("night/c.xml").name shouldBe "night/c" }
    }

    "a filter is found on the class path" - {
        "in a directory" {
            val resources = project()
            resources.filter("filters/a.xml", "in_resources")
            URLClassLoader(arrayOf(resources.toUri().toURL()), null).use { loader ->
                FilterFinder(project(), loader).find("a").predicate() shouldBe "in_resources"
                shouldThrow<FilterNotFoundException> { FilterFinder(project(), loader).find("b") }.message shouldContain "filters: a."
            }
        }
        "unless it is no regular file, which is never opened" {
            val resources = project()
            resources.resolve("filters").createDirectories()
            check(ProcessBuilder("mkfifo", "${resources.resolve("filters/pipe.xml")}").start().waitFor() == 0) { "no FIFO can be made" }
            resources.resolve("filters/folder.xml").createDirectories()
            URLClassLoader(arrayOf(resources.toUri().toURL()), null).use { loader ->
                for (name in listOf("pipe", "folder.xml")) for (project in listOf(project(), resources)) {
                    val finder = FilterFinder(project, loader)
                    shouldThrow<FilterNotFoundException> { finder.find(name) }.message shouldContain "no filter '$name'"
                }
            }
        }
        "in a jar" {
            val jar = project().resolve("filters.jar")
            JarOutputStream(jar.outputStream()).use {
                it.putNextEntry(JarEntry("filters/"))
                it.putNextEntry(JarEntry("filters/night/a.xml"))
                it.write(document("in_jar").toByteArray())
            }
            URLClassLoader(arrayOf(jar.toUri().toURL()), null).use { loader ->
                FilterFinder(project(), loader).find("night/a").predicate() shouldBe "in_jar"
                shouldThrow<FilterNotFoundException> { FilterFinder(project(), loader).find("b") }.message shouldContain "filters: night/a."
            }
        }
    }

    "the project's directory comes first, then filters/, then the class path" {
        val project = project()
        val resources = project()
        resources.filter("filters/a.xml", "in_resources")
        URLClassLoader(arrayOf(resources.toUri().toURL()), null).use { loader ->
            val finder = FilterFinder(project, loader)
            finder.find("a").predicate() shouldBe "in_resources"
            project.filter("filters/a.xml", "in_filters")
            finder.find("a").predicate() shouldBe "in_filters"
            project.filter("a.xml", "in_project")
            finder.find("a").predicate() shouldBe "in_project"
        }
    }

    "of two project directories the first comes first, and a filter that neither has is told with those of both" {
        val first = project()
        val second = project()
        val finder = FilterFinder(listOf(first, second), noResources)
        second.filter("filters/a.xml", "in_second")
        finder.find("a").predicate() shouldBe "in_second"
        first.filter("filters/a.xml", "in_first")
        finder.find("a").predicate() shouldBe "in_first"
        second.filter("b.xml")
        val message = shouldThrow<FilterNotFoundException> { finder.find("nowhere") }.message!!
        message shouldContain "$first, ${first.resolve("filters")}, $second, ${second.resolve("filters")}, filters/ on the class path"
        message shouldContain "There are these filters: a, b."
    }

    "a filter that does not exist" - {
        val project = project()
        project.filter("near.xml")
        project.filter("filters/far.xml")
        project.resolve("pom.xml").writeText("<project/>")
        val message = shouldThrow<FilterNotFoundException> { FilterFinder(project, noResources).find("nowhere") }.message!!

        "is named" { message shouldContain "There is no filter 'nowhere'" }
        "is told with where it was looked for" {
            message shouldContain "$project, ${project.resolve("filters")}, filters/ on the class path"
        }
        "is told with those that there are" { message shouldContain "There are these filters: far, near." }
        "is not told with XML files that are no filters" { message shouldNotContain "pom" }
        "is told when there are none at all" {
            shouldThrow<FilterNotFoundException> { FilterFinder(project(), noResources).find("x") }.message shouldContain
                "There are no filters"
        }
        "is told in a project directory that does not exist" {
            shouldThrow<FilterNotFoundException> { FilterFinder(project().resolve("gone"), noResources).find("x") }
        }
    }

    "a name may not lead out" {
        val parent = project()
        parent.filter("secret.xml")
        val project = parent.resolve("project").createDirectories()
        project.filter("filters/inside.xml")
        project.filter("own.xml")
        val names = listOf(
            "../secret", "../secret.xml", "filters/../../secret", "${parent.resolve("secret")}", "/etc/passwd", "..\\secret", "C:secret",
            "C:/secret", "./own", "filters//inside",
            "own/", "/", "", " ", "none", "none.xml", ".", "..", ".xml", "\u0000", "own\u0000", "a\nb", "..%2fsecret.xml/../../x",
        )
        for (name in names) withClue("'$name'") {
            shouldThrow<FilterNotFoundException> { FilterFinder(project, noResources).find(name) }.message shouldContain
                "cannot be a filter's name"
        }
        shouldThrow<FilterNotFoundException> { FilterFinder(project, noResources).find("..%2fsecret") }
    }

    "a link" - {
        val parent = project()
        val secret = parent.filter("secret.xml", "secret")
        val project = parent.resolve("project").createDirectories()
        val own = project.filter("shared/own.xml", "own")
        project.resolve("filters").createDirectories()
        val finder = FilterFinder(project, noResources)

        "that leads out of the project is refused" {
            Files.createSymbolicLink(project.resolve("filters/escape.xml"), secret)
            val message = shouldThrow<FilterNotFoundException> { finder.find("escape") }.message!!
            message shouldContain "leads out of $project"
        }
        "to a directory outside is refused too" {
            project.resolve("out").createSymbolicLinkPointingTo(parent)
            shouldThrow<FilterNotFoundException> { finder.find("out/secret") }.message shouldContain "leads out"
        }
        "inside the project is followed" {
            project.resolve("filters/inner.xml").createSymbolicLinkPointingTo(own)
            finder.find("inner").predicate() shouldBe "own"
        }
        "to the project's directory itself does not matter" {
            val alias = parent.resolve("alias").createSymbolicLinkPointingTo(project)
            FilterFinder(alias, noResources).find("shared/own").predicate() shouldBe "own"
        }
        "to itself is no filter" {
            project.resolve("loop.xml").createSymbolicLinkPointingTo(project.resolve("loop.xml"))
            shouldThrow<FilterNotFoundException> { finder.find("loop") }
        }
    }

    "a directory is no filter" {
        val project = project()
        project.resolve("a.xml").createDirectories()
        shouldThrow<FilterNotFoundException> { FilterFinder(project, noResources).find("a") }
    }

    "a file that is refused is named with its path" {
        val project = project()
        project.resolve("bad.xml").writeText("<PerceptionFilter>\n<filter/></PerceptionFilter>")
        shouldThrow<FilterException> { FilterFinder(project, noResources).find("bad") }.message shouldContain
            "${project.resolve("bad.xml")}:2:1: the rule has no predicate"
    }
})
