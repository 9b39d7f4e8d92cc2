import org.jetbrains.kotlin.gradle.dsl.KotlinJvmProjectExtension

plugins { `java-library` }

// the board for tests, which those of javino-java and argo-arch compile too
sourceSets.named("main") { java.srcDir("../javino-java/src/fake/java") }

// agents with faults, for the tests here and for the benchmarks
configure<KotlinJvmProjectExtension> {
    sourceSets.named("test") { kotlin.srcDir("src/planted/kotlin") }
}
sourceSets.named("test") { resources.srcDir("src/planted/resources") }

dependencies {
    compileOnly(libs.jason) // the user's project brings Jason
    api(project(":argo-arch"))
    implementation(project(":argo-recording"))
    testImplementation(libs.jason)
    testImplementation(libs.mockk)
}
