package argo.lsp.agents

import argo.check.rules.INTERNAL_ACTION_NAMES
import argo.tools.command.filesOn
import java.net.URLClassLoader

/**
 * The names and documentation of Jason's internal actions. The documentation comes from Jason's classes. [classPath] is a class path that
 * contains Jason; null if there is no documentation.
 */
internal class JasonManual(classPath: String?) {
    private val loader = classPath?.let { path ->
        URLClassLoader(filesOn(path).map { it.toUri().toURL() }.toTypedArray(), ClassLoader.getPlatformClassLoader())
    }

    /** The pages of actions in Markdown, by names such as `.print`. */
    val actions: Map<String, String> = INTERNAL_ACTION_NAMES.filter { it.startsWith(".") }.associateWith { page(it).orEmpty() }

    /** Returns the annotation of the action's class as a page; null if the class has none, as in some versions of Jason. */
    private fun page(action: String): String? {
        val type = try {
            loader?.loadClass("jason.stdlib$action")
        } catch (_: ClassNotFoundException) {
            null
        } catch (_: LinkageError) {
            null
        }
        val manual = type?.annotations?.find { it.annotationClass.simpleName == "Manual" } ?: return null
        fun said(part: String) = manual.annotationClass.java.getMethod(part).invoke(manual)
        val arguments = (said("argsHint") as Array<*>).map { "$it" }.filter(String::isNotBlank)
        return "`${said("literal")}`\n\n${said("hint")}" + arguments.joinToString("") { "\n- $it" }
    }
}
