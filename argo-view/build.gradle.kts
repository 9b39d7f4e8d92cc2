plugins {
    `java-library`
    alias(libs.plugins.kotlin.serialization)
}

dependencies {
    compileOnly(libs.jason) // the user's project brings Jason
    api(project(":argo-arch"))
    implementation(libs.serialization.json) // what the page is sent
    compileOnly(project(":argo-tools")) // the tool view, of recordings; argo.jar has the tools and recordings, other projects need them not
    compileOnly(project(":argo-recording"))
    compileOnly(libs.picocli)
    testImplementation(libs.jason)
    testImplementation(libs.selenium) // tests open the page in a browser
    testImplementation(project(":argo-tools"))
    testImplementation(project(":argo-recording"))
    testImplementation(project(":argo-testkit")) // tests record agents
    testImplementation(libs.picocli)
}
