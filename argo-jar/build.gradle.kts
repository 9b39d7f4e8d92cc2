/** The one jar that a Jason project adds: everything but Jason. */
val argoJar by tasks.registering(JavaExec::class) {
    description = "Packs argo.jar."
    val jar = layout.buildDirectory.file("libs/argo.jar")
    val packed = files(configurations.runtimeClasspath)
    val version = project.version.toString()
    inputs.files(packed)
    inputs.property("version", version)
    outputs.file(jar)
    classpath(sourceSets.main.map { it.output }, configurations.compileClasspath)
    mainClass = "argo.packing.MainKt"
    argumentProviders.add(CommandLineArgumentProvider { listOf(jar.get().asFile.path, version, packed.asPath) })
}

tasks.assemble { dependsOn(argoJar) }

tasks.test {
    dependsOn(argoJar)
    systemProperty("argo.jar", layout.buildDirectory.file("libs/argo.jar").get().asFile.path)
}
