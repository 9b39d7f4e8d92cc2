package argo.layers

import com.tngtech.archunit.ArchConfiguration
import com.tngtech.archunit.base.DescribedPredicate
import com.tngtech.archunit.core.domain.JavaClass
import com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage
import com.tngtech.archunit.core.importer.ClassFileImporter
import com.tngtech.archunit.core.importer.ImportOption
import com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes
import com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses
import com.tngtech.archunit.library.dependencies.SliceAssignment
import com.tngtech.archunit.library.dependencies.SliceIdentifier
import com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainAll
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText

/**
 * Tests that each package knows only allowed packages. CONTRIBUTING.md has the table of allowed packages, and docs/architecture.md has
 * the order of packages.
 */
class LayersSpec : FunSpec({
    // the rules ask only for the names of what the product uses; reading those classes, too, takes a quarter more time
    ArchConfiguration.get().setResolveMissingDependenciesFromClassPath(false)
    val product = ClassFileImporter().withImportOption(ImportOption.DoNotIncludeTests()).importPackages("argo", "javino", "jason.stdlib")
        .that(
            DescribedPredicate.describe("are the product's") {
                it.packageName != "argo.packing" && !it.packageName.startsWith("jason.stdlib.") || it.packageName == "jason.stdlib.argo"
            },
        )

    fun packages(vararg names: String) = resideInAnyPackage(*names)

    /** Selects the product's classes outside of the packages [allowed]. */
    fun productBut(vararg allowed: String): DescribedPredicate<JavaClass> =
        packages("argo..", "javino..").and(DescribedPredicate.not(packages(*allowed)))
            .`as`("another package of the product than ${allowed.joinToString()}")

    /** The packages of the architecture. The value lists the packages that the key may know. */
    val order = mapOf(
        "argo.observing" to emptyList(),
        "argo.links" to emptyList(),
        "argo.boundary" to listOf("argo.observing"),
        "argo.watching" to listOf("argo.observing"),
        "argo.insides" to emptyList(),
        "argo.mind" to listOf("argo.observing"),
        "argo.platform" to listOf("argo.links", "argo.boundary", "argo.insides"),
        "argo.resuming" to listOf("argo.mind", "argo.observing", "argo.platform"),
        "argo.calls" to listOf("argo.observing", "argo.links"),
        "argo.connecting" to listOf("argo.calls", "argo.platform", "argo.links"),
        "argo.acting" to listOf("argo.connecting", "argo.calls", "argo.platform", "argo.links", "argo.observing"),
        "argo.sensing" to listOf("argo.acting", "argo.connecting", "argo.calls", "argo.platform", "argo.links"),
        "argo.perception" to
            listOf("argo.sensing", "argo.acting", "argo.connecting", "argo.calls", "argo.platform", "argo.links", "argo.observing"),
        "argo.boards" to
            listOf(
                "argo.perception", "argo.sensing", "argo.acting", "argo.connecting", "argo.calls", "argo.platform", "argo.links",
                "argo.observing",
            ),
        "argo.orders" to
            listOf("argo.boards", "argo.perception", "argo.mind", "argo.platform", "argo.boundary", "argo.insides", "argo.observing"),
        "argo.pausing" to
            listOf(
                "argo.orders", "argo.boards", "argo.connecting", "argo.acting", "argo.calls", "argo.platform", "argo.insides", "argo.links",
                "argo.observing",
            ),
    )

    val lines = arrayOf("javino", "javino.link", "javino.wire")

    test("the rules see the packages that they speak of") {
        product.map { it.packageName }.toSet() shouldContainAll listOf(
            "argo", "argo.links", "argo.connecting", "argo.sensing", "argo.acting", "argo.perception", "argo.view",
            "argo.debug", "argo.pausing",
            "argo.filters", "argo.filters.format", "argo.filters.matching", "argo.filters.jason", "argo.check.syntax", "argo.tools",
            "argo.lsp", "argo.ros", "argo.fleet", "argo.fleet.agents", "argo.fleet.node", "argo.fleet.cluster",
            "argo.ros.bridge", "argo.ros.mapping", "argo.ros.joining", "argo.ros.checking", "argo.mcap", "argo.recording.storage", "javino",
            "javino.link", "javino.serial", "javino.tcp", "javino.sim",
        )
    }

    test("no packages know each other in a circle") {
        val packages = object : SliceAssignment {
            override fun getDescription() = "packages"
            override fun getIdentifierOf(javaClass: JavaClass): SliceIdentifier = SliceIdentifier.of(javaClass.packageName)
        }
        slices().assignedFrom(packages).should().beFreeOfCycles().check(product)
    }

    context("links") {
        test("know Java and the serial driver alone") {
            classes().that().resideInAPackage("javino..").should()
                .onlyDependOnClassesThat().resideInAnyPackage("java..", "javax.net..", "jdk..", "javino..", "com.fazecast..").check(product)
        }
        test("are not built on what moves the bytes") {
            noClasses().that().resideInAnyPackage("javino", "javino.link").should()
                .dependOnClassesThat().resideInAnyPackage("javino.serial..", "javino.tcp..", "javino.sim..").check(product)
        }
        test("are built on frames and ports, which do not know them") {
            noClasses().that().resideInAPackage("javino").should().dependOnClassesThat().resideInAPackage("javino.link").check(product)
        }
    }

    context("filters") {
        test("know no serial lines") {
            noClasses().that().resideInAPackage("argo.filters..").should().dependOnClassesThat().resideInAPackage("javino..").check(product)
        }
        test("know Jason in one adapter alone") {
            noClasses().that().resideInAPackage("argo.filters..").and().resideOutsideOfPackage("argo.filters.jason").should()
                .dependOnClassesThat().resideInAPackage("jason..").check(product)
        }
    }

    context("the architecture") {
        order.forEach { (name, below) ->
            test("$name knows ${below.joinToString().ifEmpty { "no other package of it" }}") {
                noClasses().that().resideInAPackage(name).should()
                    .dependOnClassesThat(productBut(name, "argo.filters..", *lines, *below.toTypedArray())).check(product)
            }
        }
        test("reaches private members of Jason in argo.insides only") {
            noClasses().that().resideOutsideOfPackages("argo.insides", "javino..").should()
                .callMethodWhere(
                    DescribedPredicate.describe("makes a private member accessible") {
                        it.target.name in setOf("setAccessible", "trySetAccessible")
                    },
                ).check(product)
        }
        test("imports, for its comments too, no package that it does not know") {
            order.flatMap { (name, below) ->
                importedBy(name).filterNot { (_, known) -> known in below + name || known.startsWith("argo.filters") }
            }.shouldBeEmpty()
        }
        test("does not know how bytes move") {
            noClasses().that().resideInAnyPackage("argo", *order.keys.toTypedArray())
                .should().dependOnClassesThat().resideInAnyPackage("javino.serial..", "javino.tcp..", "javino.sim..").check(product)
        }
        test("does not know its live view") {
            noClasses().that().resideOutsideOfPackage("argo.view..").should()
                .dependOnClassesThat().resideInAPackage("argo.view..").check(product)
        }
    }

    context("the live view") {
        test("knows observed agents, filters and kinds of percepts, and of ARGO nothing else") {
            noClasses().that().resideInAPackage("argo.view").should()
                .dependOnClassesThat(productBut("argo.view", "argo.observing", "argo.filters..", "javino")).check(product)
        }
        test("shows recordings knowing how they are read and what a tool is") {
            noClasses().that().resideInAPackage("argo.view.timeline").should()
                .dependOnClassesThat(
                    productBut("argo.view..", "argo.recording", "argo.recording.replay", "argo.tools.command", "argo.tools.why"),
                ).check(product)
        }
    }

    context("debuggers") {
        test("reach agents knowing observed agents, and of ARGO nothing else, and are known by nobody") {
            noClasses().that().resideInAPackage("argo.debug").should()
                .dependOnClassesThat(productBut("argo.debug", "argo.observing", "argo.filters..")).check(product)
            noClasses().that().resideOutsideOfPackage("argo.debug").should()
                .dependOnClassesThat().resideInAPackage("argo.debug").check(product)
        }
    }

    context("robots that speak ROS") {
        test("know links, filters and the format of bags, and of ARGO nothing else") {
            noClasses().that().resideInAnyPackage("argo.ros", "argo.ros.bridge", "argo.ros.mapping").should()
                .dependOnClassesThat(productBut("argo.ros..", "argo.links", "argo.filters..", "argo.mcap", *lines)).check(product)
        }
        test("take boards in knowing links, observed agents, the platform, filters and what a tool is") {
            val known = arrayOf(
                "argo.links", "argo.observing", "argo.platform", "argo.filters..", "argo.tools.board", "argo.tools.command",
            )
            noClasses().that().resideInAnyPackage("argo.ros.joining", "argo.ros.checking").should()
                .dependOnClassesThat(productBut("argo.ros..", *lines, *known)).check(product)
        }
        test("are known by nobody") {
            noClasses().that().resideOutsideOfPackage("argo.ros..").should()
                .dependOnClassesThat().resideInAPackage("argo.ros..").check(product)
        }
    }

    context("fleets") {
        test("have computers in touch, which know no agents, nor anything of the product") {
            noClasses().that().resideInAPackage("argo.fleet.cluster").should()
                .dependOnClassesThat(productBut("argo.fleet.cluster", "javino.tcp").or(packages("jason.."))).check(product)
        }
        test("know who is where without Jason") {
            noClasses().that().resideInAPackage("argo.fleet.node").should()
                .dependOnClassesThat(productBut("argo.fleet.node", "argo.fleet.cluster").or(packages("jason.."))).check(product)
        }
        test("know of the rest what a mind is, how messages are written, what live views see, and what a tool is") {
            noClasses().that().resideInAPackage("argo.fleet..").should()
                .dependOnClassesThat(
                    productBut(
                        "argo.fleet..", "argo.insides", "argo.mind", "argo.observing", "argo.platform", "argo.recording.agent",
                        "argo.tools.command", "javino.tcp",
                    ),
                ).check(product)
        }
        test("know JGroups in the cluster only, and are known by nobody") {
            noClasses().that().resideOutsideOfPackage("argo.fleet.cluster").should()
                .dependOnClassesThat().resideInAPackage("org.jgroups..").check(product)
            noClasses().that().resideOutsideOfPackage("argo.fleet..").should()
                .dependOnClassesThat().resideInAPackage("argo.fleet..").check(product)
        }
    }

    context("recordings") {
        test("are of a format that knows nothing of the product") {
            noClasses().that().resideInAPackage("argo.mcap..").should()
                .dependOnClassesThat(productBut("argo.mcap..").or(packages("jason.."))).check(product)
        }
        test("are stored without knowing what they hold") {
            noClasses().that().resideInAPackage("argo.recording.storage..").should()
                .dependOnClassesThat(productBut("argo.recording.storage..", "argo.mcap..").or(packages("jason.."))).check(product)
        }
        test("do not know how bytes move") {
            noClasses().that().resideInAPackage("argo.recording..")
                .should().dependOnClassesThat().resideInAnyPackage("javino.serial..", "javino.tcp..", "javino.sim..").check(product)
        }
    }

    context("checks of programs") {
        test("know no Jason, and not how bytes move") {
            noClasses().that().resideInAPackage("argo.check..").should()
                .dependOnClassesThat().resideInAnyPackage("jason..", "javino.serial..", "javino.tcp..", "javino.sim..").check(product)
        }
        test("read programs knowing only texts") {
            noClasses().that().resideInAPackage("argo.check.syntax").should()
                .dependOnClassesThat(productBut("argo.check.syntax")).check(product)
        }
        test("know filters, and of the architecture nothing") {
            noClasses().that().resideInAPackage("argo.check..").should()
                .dependOnClassesThat(productBut("argo.check..", "argo.filters..", "javino")).check(product)
        }
    }

    context("the language server") {
        test("knows what is checked, filters, what a tool is and how Jason is found") {
            noClasses().that().resideInAPackage("argo.lsp..").should()
                .dependOnClassesThat(
                    productBut("argo.lsp..", "argo.check..", "argo.filters..", "argo.tools.command", "argo.tools.replay", "javino"),
                ).check(product)
        }
        test("is known by nobody, and knows no Jason") {
            noClasses().that().resideOutsideOfPackage("argo.lsp..").should()
                .dependOnClassesThat().resideInAPackage("argo.lsp..").check(product)
            noClasses().that().resideInAPackage("argo.lsp..").should().dependOnClassesThat().resideInAPackage("jason..").check(product)
        }
    }

    context("the tools") {
        test("know no Jason") {
            noClasses().that().resideInAPackage("argo.tools..").should().dependOnClassesThat().resideInAPackage("jason..").check(product)
        }
        test("know of the architecture only links") {
            noClasses().that().resideInAPackage("argo.tools..").should()
                .dependOnClassesThat(
                    productBut(
                        "argo.tools..", "argo.links", "argo.check..", "argo.filters..", "argo.mcap", "argo.recording",
                        "argo.recording.replay", "argo.recording.why",
                        "javino..",
                    ),
                ).check(product)
        }
    }
})

/**
 * Returns the packages of ARGO that the sources of package [name] import, each with its source file. Classes do not show imports for
 * comments.
 */
private fun importedBy(name: String): List<Pair<String, String>> =
    Path.of("../argo-arch/src/main/kotlin", *name.split('.').toTypedArray()).listDirectoryEntries("*.kt").flatMap { file ->
        Regex("""(?m)^import (argo(?:\.[a-z]\w*)*)\.\w+""").findAll(file.readText()).map { file.name to it.groupValues[1] }
    }
